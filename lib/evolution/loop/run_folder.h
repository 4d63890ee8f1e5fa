/// The folder of a run: all files that show a run of a loop and allow to repeat it.
///
///     run.json              program and command lines (RunDescription)
///     start.ply             initial mesh, if there is one
///     target.ply            target of a morph; for a movie targets/00001.ply and so on
///     cameras.txt, photographs/   views of a reconstruction (run_views.h)
///     views/00001/          cameras and photographs of a movie's time step, and so on
///     frames/frame-00000.ply, and so on, and log.csv: written while the loop runs (record.h)
///     events.csv            events of an evolution, written while the loop runs
///     result.ply, report.json     written at the end
///
/// Files are written atomically. A new run in the folder of an earlier run removes the files of
/// that run, and no others. All functions throw OutputError if a file cannot be written.
/// Deterministic.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace transformesh {

namespace run_file {
inline constexpr const char *description = "/run.json", *start = "/start.ply",
                            *target = "/target.ply", *targets = "/targets",
                            *cameras = "/cameras.txt", *photographs = "/photographs",
                            *views = "/views", *frames = "/frames", *log = "/log.csv",
                            *events = "/events.csv", *report = "/report.json",
                            *result = "/result.ply";
}  // namespace run_file

/// Contents of run.json. The JSON keys are the names of the members, and `layout`, whose value 1 is
/// the version of the folder's layout.
struct RunDescription {
  std::string tool, version;
  /// Command lines, quoted for a shell. The first began the run, the others continued it.
  std::vector<std::string> commands;
};
using RunFiles = std::vector<std::pair<std::string, std::string>>;  ///< names and bytes of files
using RunPaths = std::vector<std::pair<std::size_t, std::string>>;  ///< numbers and paths, in order

/// Throws UsageError if the folder contains files, but not those of a run.
void check_run_folder(const std::string& folder);
/// Starts a run in a folder: writes its description, removes the files of an earlier run, and
/// writes `files`.
void begin_run(const std::string& folder, const RunDescription& description, const RunFiles& files);
/// Writes additional files to the folder of a run, while its loop runs.
void add_to_run(const std::string& folder, const RunFiles& files);
/// Adds a command line to the description of the run, and removes files that were not written
/// completely.
void continue_run(const std::string& folder, const std::string& command);

/// Reads the description of a run. Throws InputError if the folder does not contain a run, or if
/// its layout has a later version than this program supports.
RunDescription read_run(const std::string& folder);

/// Return the existing frames, targets and view folders, with their numbers. Targets and view
/// folders of a movie have the numbers of their frames. Otherwise there is at most one of each,
/// with the number 0.
RunPaths run_frames(const std::string& folder);
RunPaths run_targets(const std::string& folder);
RunPaths run_views(const std::string& folder);
/// Returns the name of a file or folder of a movie: `files`, then '/', the number with five digits,
/// and the ending. `files` is run_file::targets or run_file::views.
std::string run_name(const char* files, std::size_t number, const std::string& ending);

}  // namespace transformesh

/// The folder of a RUN: all that shows and repeats one run of a loop, under fixed names.
///
///     run.json              which program with which command lines, see RunDescription
///     start.ply             the mesh given, where one is
///     target.ply            what a morph moves towards; of a movie targets/00001.ply and so on
///     cameras.txt, photographs/                     the views of a reconstruction (run_views.h);
///     of
///                           a movie those in views/00001 and so on
///     frames/frame-00000.ply and so on, log.csv     as the loop goes on (record.h)
///     events.csv                                    of an evolution, likewise
///     result.ply, report.json                       at the end
///
/// Each file appears complete or not at all. A run that begins where there was another one removes
/// the files of that; nothing else in the folder is touched. All functions throw OutputError where
/// something cannot be written. Deterministic.
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

/// As run.json holds it, under these names, beside `layout`: 1.
struct RunDescription {
  std::string tool, version;
  /// As a shell reads them: the one that began the run, then those that continued it.
  std::vector<std::string> commands;
};
using RunFiles = std::vector<std::pair<std::string, std::string>>;  ///< names and bytes
using RunPaths = std::vector<std::pair<std::size_t, std::string>>;  ///< numbers and paths, in order

/// Throws UsageError where the folder holds files and no run.
void check_run_folder(const std::string& folder);
/// Writes the description, removes what an earlier run has left, and writes the files given.
void begin_run(const std::string& folder, const RunDescription& description, const RunFiles& files);
/// Writes more of them as the loop goes on.
void add_to_run(const std::string& folder, const RunFiles& files);
/// Adds a command to the description, and removes what was not written to its end.
void continue_run(const std::string& folder, const std::string& command);

/// Throws InputError where the folder is no run, or is one of a later layout.
RunDescription read_run(const std::string& folder);

/// What is there. Targets and views of a movie, whose paths are those of their folders, have the
/// numbers of their frames; those of other runs have the number 0.
RunPaths run_frames(const std::string& folder);
RunPaths run_targets(const std::string& folder);
RunPaths run_views(const std::string& folder);
/// `targets` or `views`, then `/`, five digits of the number and the ending.
std::string run_name(const char* files, std::size_t number, const std::string& ending);

}  // namespace transformesh

/// The folder of a RUN: all that shows and repeats one run of a loop, under fixed names.
///
///     run.json              which program with which command lines, see RunDescription
///     start.ply             the mesh given, where one is
///     target.ply            what a morph moves towards
///     cameras.txt, photographs/                     the views of a reconstruction (run_views.h)
///     frames/frame-00000.ply and so on, log.csv     as the loop goes on (record.h)
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
inline constexpr const char* description = "/run.json";
inline constexpr const char* start = "/start.ply";
inline constexpr const char* target = "/target.ply";
inline constexpr const char* cameras = "/cameras.txt";
inline constexpr const char* photographs = "/photographs";
inline constexpr const char* frames = "/frames";
inline constexpr const char* log = "/log.csv";
inline constexpr const char* report = "/report.json";
inline constexpr const char* result = "/result.ply";
}  // namespace run_file

/// As run.json holds it, under these names, beside `layout`: 1.
struct RunDescription {
  std::string tool, version;
  /// As a shell reads them: the one that began the run, then those that continued it.
  std::vector<std::string> commands;
};

/// Throws UsageError where the folder holds files and no run.
void check_run_folder(const std::string& folder);

/// Writes the description, removes what an earlier run has left, and writes the files given (name
/// and bytes).
void begin_run(const std::string& folder, const RunDescription& description,
               const std::vector<std::pair<std::string, std::string>>& files);

/// Adds a command to the description.
void continue_run(const std::string& folder, const std::string& command);

/// Throws InputError where the folder is no run, or is one of a later layout.
RunDescription read_run(const std::string& folder);

/// The frames that are there, in order: their numbers and paths.
std::vector<std::pair<std::size_t, std::string>> run_frames(const std::string& folder);

}  // namespace transformesh

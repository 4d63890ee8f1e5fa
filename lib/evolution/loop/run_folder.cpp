#include "evolution/loop/run_folder.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>

#include "evolution/loop/record.h"
#include "io/streams/atomic_file.h"
#include "support/number.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Version of the folder's layout; folders with a later version are refused.
constexpr int layout = 1;
constexpr const char* mesh_ending = ".ply";

/// Returns the files of a folder that are named by a prefix, a number and an ending. Sorts them by
/// number.
RunPaths numbered(const std::string& folder, std::string_view prefix, const char* ending) {
  RunPaths found;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const std::string stem = entry.path().stem().string();
    if (entry.path().extension() != ending || !stem.starts_with(prefix)) continue;
    if (const auto number = number_in<std::size_t>(stem.substr(prefix.size())))
      found.emplace_back(*number, entry.path().string());
  }
  std::ranges::sort(found);
  return found;
}

/// Returns `of_movie` unless it is empty. If it is empty and `file` exists, returns one entry:
/// number 0 and `path`.
RunPaths numbered_or(const RunPaths& of_movie, const std::string& file, const std::string& path) {
  std::error_code ignored;
  if (of_movie.empty() && fs::exists(file, ignored)) return {{0, path}};
  return of_movie;
}

void write_description(const std::string& folder, const RunDescription& description) {
  const Json json = {{"layout", layout},
                     {"tool", description.tool},
                     {"version", description.version},
                     {"commands", description.commands}};
  write_file(folder + run_file::description,
             json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
}

void remove_views(const std::string& folder) {
  std::error_code ignored;
  fs::remove(folder + run_file::cameras, ignored);
  const std::string photographs = folder + run_file::photographs;
  for (const auto& entry : fs::directory_iterator(photographs, ignored))
    if (entry.path().extension() == ".png") fs::remove(entry.path(), ignored);
  // Keep the folder if it contains files that do not belong to a run.
  if (fs::is_empty(photographs, ignored)) fs::remove(photographs, ignored);
}

/// True for names of temporary files that AtomicFile creates: `.NAME.PROCESS-ATTEMPT.tmp`.
bool is_unfinished(const fs::path& file) {
  const std::string name = file.stem().string();
  const std::string numbers = file.stem().extension().string();
  const std::size_t dash = std::min(numbers.find('-'), numbers.size());
  const auto is_number = [](const std::string& text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  };
  return file.extension() == ".tmp" && name.starts_with('.') && numbers.size() + 2 <= name.size() &&
         dash > 0 && dash < numbers.size() && is_number(numbers.substr(1, dash - 1)) &&
         is_number(numbers.substr(dash + 1));
}

/// Removes the temporary files of a run that was killed while it was writing (atomic_file.h).
void remove_unfinished_files(const std::string& folder) {
  std::error_code ignored;
  std::vector<fs::path> paths;
  for (auto entry = fs::recursive_directory_iterator(folder, ignored);
       entry != fs::recursive_directory_iterator(); entry.increment(ignored))
    if (is_unfinished(entry->path())) paths.push_back(entry->path());
  for (const fs::path& path : paths) fs::remove(path, ignored);
}

void remove_files_of_run(const std::string& folder) {
  remove_unfinished_files(folder);
  std::error_code ignored;
  for (const char* name :
       {run_file::result, run_file::report, run_file::log, run_file::events, run_file::start})
    fs::remove(folder + name, ignored);
  for (const auto& [number, path] : run_frames(folder)) fs::remove(path, ignored);
  for (const auto& [number, path] : numbered(folder + run_file::targets, "", mesh_ending))
    fs::remove(path, ignored);
  fs::remove(folder + run_file::target, ignored);
  for (const auto& [number, path] : numbered(folder + run_file::views, "", "")) {
    remove_views(path);
    if (fs::is_empty(path, ignored)) fs::remove(path, ignored);
  }
  remove_views(folder);
  for (const char* name : {run_file::targets, run_file::views})
    if (fs::is_empty(folder + name, ignored)) fs::remove(folder + name, ignored);
}

/// True if the path has the name of a run's recorded state, which begins with the name of the
/// result, or that of a temporary file. A run that was killed before its description was complete
/// leaves only such files.
bool may_be_of_a_run(const fs::path& path) {
  return is_unfinished(path) ||
         path.filename().string().starts_with(std::string(run_file::result + 1) + ".tm-");
}

}  // namespace

void check_run_folder(const std::string& folder) {
  std::error_code ignored;
  if (fs::exists(folder + run_file::description, ignored)) return;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    if (!may_be_of_a_run(entry.path()))
      throw UsageError("'" + folder + "' holds " + entry.path().filename().string() +
                       ", but not a run: name a folder that is new, empty or holds an earlier run");
  }
}

void begin_run(const std::string& folder, const RunDescription& description,
               const RunFiles& files) {
  make_folder(folder);
  // Write the description first, so that a folder of an interrupted run is recognized as such.
  write_description(folder, description);
  remove_files_of_run(folder);
  add_to_run(folder, files);
}

void add_to_run(const std::string& folder, const RunFiles& files) {
  for (const auto& [name, bytes] : files) {
    make_folder(fs::path(folder + name).parent_path().string());
    write_file(folder + name, bytes);
  }
}

std::string run_name(const char* files, std::size_t number, const std::string& ending) {
  const std::string digits = std::to_string(number);
  return std::string(files) + '/' + std::string(5 - std::min<std::size_t>(digits.size(), 5), '0') +
         digits + ending;
}

void continue_run(const std::string& folder, const std::string& command) {
  remove_unfinished_files(folder);
  RunDescription description = read_run(folder);
  description.commands.push_back(command);
  write_description(folder, description);
}

RunDescription read_run(const std::string& folder) {
  const std::string name = folder + run_file::description;
  std::ifstream file(name, std::ios::binary);
  if (!file)
    throw InputError(ErrorKind::not_a_run, "'" + folder + "' is not a run: run.json is missing",
                     {.name = folder});
  const Json json =
      Json::parse(std::string(std::istreambuf_iterator<char>(file), {}), nullptr, false);
  try {
    if (json.at("layout") > layout)
      throw InputError("'" + name + "' was written by a later version of this suite");
    return {json.at("tool"), json.at("version"), json.at("commands")};
  } catch (const Json::exception&) {
    throw InputError("'" + name + "' is damaged: it does not describe a run");
  }
}

RunPaths run_frames(const std::string& folder) {
  return numbered(folder + run_file::frames, frame_prefix, mesh_ending);
}

RunPaths run_targets(const std::string& folder) {
  const std::string target = folder + run_file::target;
  return numbered_or(numbered(folder + run_file::targets, "", mesh_ending), target, target);
}

RunPaths run_views(const std::string& folder) {
  RunPaths of_movie = numbered(folder + run_file::views, "", "");
  // Skip folders without cameras: cameras are written last, so such a folder is incomplete.
  std::erase_if(of_movie,
                [](const auto& one) { return !fs::exists(one.second + run_file::cameras); });
  return numbered_or(of_movie, folder + run_file::cameras, folder);
}

}  // namespace transformesh

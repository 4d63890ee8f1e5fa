#include "tm/evolution/run_folder.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>

#include "tm/io/atomic_file.h"
#include "tm/support/error.h"
#include "tm/support/number.h"

namespace transformesh {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int layout = 1;
constexpr std::string_view frame_prefix = "frame-";

std::optional<std::size_t> frame_number(const fs::path& path) {
  const std::string stem = path.stem().string();
  if (path.extension() != ".ply" || !stem.starts_with(frame_prefix)) return std::nullopt;
  return number_in<std::size_t>(stem.substr(frame_prefix.size()));
}

void write_description(const std::string& folder, const RunDescription& description) {
  const Json json = {{"layout", layout},
                     {"tool", description.tool},
                     {"version", description.version},
                     {"commands", description.commands}};
  write_file(folder + run_file::description,
             json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
}

void remove_files_of_run(const std::string& folder) {
  std::error_code ignored;
  for (const char* name : {run_file::result, run_file::report, run_file::log, run_file::start,
                           run_file::target, run_file::cameras})
    fs::remove(folder + name, ignored);
  for (const auto& [number, path] : run_frames(folder)) fs::remove(path, ignored);
  for (const auto& entry : fs::directory_iterator(folder + run_file::photographs, ignored))
    if (entry.path().extension() == ".png") fs::remove(entry.path(), ignored);
}

/// A run that was stopped before it had a description has left its state, named after the result.
bool may_be_of_a_run(const fs::path& path) {
  return path.filename().string().starts_with(std::string(run_file::result + 1) + ".tm-");
}

}  // namespace

void check_run_folder(const std::string& folder) {
  std::error_code ignored;
  if (fs::exists(folder + run_file::description, ignored)) return;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    if (!may_be_of_a_run(entry.path()))
      throw UsageError("'" + folder + "' holds " + entry.path().filename().string() +
                       " and no run: name a folder that is new, empty or an earlier run");
  }
}

void begin_run(const std::string& folder, const RunDescription& description,
               const std::vector<std::pair<std::string, std::string>>& files) {
  make_folder(folder);
  // First, so that the folder is that of a run whenever this one is stopped.
  write_description(folder, description);
  remove_files_of_run(folder);
  for (const auto& [name, bytes] : files) {
    make_folder(fs::path(folder + name).parent_path().string());
    write_file(folder + name, bytes);
  }
}

void continue_run(const std::string& folder, const std::string& command) {
  RunDescription description = read_run(folder);
  description.commands.push_back(command);
  write_description(folder, description);
}

RunDescription read_run(const std::string& folder) {
  const std::string name = folder + run_file::description;
  std::ifstream file(name, std::ios::binary);
  if (!file)
    throw InputError("'" + folder +
                     "' is no run: it has no run.json, which a loop writes with --run " + folder);
  const Json json =
      Json::parse(std::string(std::istreambuf_iterator<char>(file), {}), nullptr, false);
  try {
    if (json.at("layout") > layout)
      throw InputError("'" + name + "' is of a later version of this suite");
    return {json.at("tool"), json.at("version"), json.at("commands")};
  } catch (const Json::exception&) {
    throw InputError("'" + name + "' is damaged: it describes no run");
  }
}

std::vector<std::pair<std::size_t, std::string>> run_frames(const std::string& folder) {
  std::vector<std::pair<std::size_t, std::string>> frames;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder + run_file::frames, ignored))
    if (const auto number = frame_number(entry.path()))
      frames.emplace_back(*number, entry.path().string());
  std::ranges::sort(frames);
  return frames;
}

}  // namespace transformesh

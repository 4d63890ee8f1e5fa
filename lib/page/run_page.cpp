#include "page/run_page.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "evolution/loop/recorded_views.h"
#include "io/streams/streams.h"
#include "support/number.h"
#include "support/parallel.h"
#include "transformesh/compare.h"
#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"

namespace transformesh {
namespace {

/// Returns the contents of a file; empty if it does not exist.
std::string text_in(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Returns the number at the start of the last complete line.
std::size_t last_number(const std::string& log) {
  const std::size_t end = log.rfind('\n');
  if (end == std::string::npos || end == 0) return 0;
  const std::size_t begin = log.rfind('\n', end - 1) + 1;
  const std::string line = log.substr(begin, end - begin);
  return number_in<std::size_t>(line.substr(0, line.find(','))).value_or(0);
}

RunPaths every_few(const RunPaths& files, std::size_t every) {
  RunPaths kept;
  for (std::size_t i = 0; i < files.size(); ++i)
    if (i % every == 0 || i + 1 == files.size()) kept.push_back(files[i]);
  return kept;
}

std::string name_of_folder(const std::string& folder) {
  std::error_code ignored;
  const std::filesystem::path path = std::filesystem::absolute(folder, ignored).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

bool is_new(const RunPaths::value_type* shown, const auto& known) {
  return shown != nullptr && (known.empty() || known.back().number != shown->first);
}

}  // namespace

PageMesh read_frame(std::size_t number, const std::string& path, const Mesh& target) {
  Mesh mesh = read_mesh_file(path);
  if (!target.positions.empty() && !mesh.positions.empty())
    mesh.vertex_columns.get("distance", Scalar::float64, mesh.positions.size()).values =
        vertex_distances(mesh, target);
  return {number, path.ends_with(run_file::result) ? "result" : "", pack(mesh)};
}

Mesh read_run_target(const std::string& path) {
  return read_mesh(read_all(path).view(), path).document.mesh;
}

const RunPaths::value_type* shown_with(std::size_t number, const RunPaths& paths) {
  const auto found =
      std::ranges::find_if(paths, [&](const auto& one) { return one.first >= number; });
  if (found != paths.end()) return &*found;
  return paths.empty() ? nullptr : &paths.back();
}

PageRun read_run_texts(const std::string& folder) {
  const RunDescription description = read_run(folder);
  PageRun run;
  run.name = name_of_folder(folder);
  run.tool = description.tool;
  run.version = description.version;
  run.commands = description.commands;
  run.log = text_in(folder + run_file::log);
  run.events = text_in(folder + run_file::events);
  run.report = text_in(folder + run_file::report);
  return run;
}

RunPaths run_mesh_files(const std::string& folder, const std::string& log) {
  RunPaths files = run_frames(folder);
  const std::string result = folder + run_file::result;
  const std::size_t last = last_number(log);
  if (std::filesystem::exists(result) && (files.empty() || files.back().first < last))
    files.emplace_back(last, result);
  return files;
}

PageRun read_run_page(const std::string& folder, const RunPageOptions& options,
                      const Progress& progress) {
  PageRun run = read_run_texts(folder);
  const RunPaths targets = run_targets(folder), views = run_views(folder);
  const RunPaths files = every_few(run_mesh_files(folder, run.log), options.every);
  if (files.empty()) throw InputError("'" + folder + "' has neither frames nor a result yet");
  Mesh target;
  for (const auto& [number, path] : files) {
    progress("pack", static_cast<double>(run.meshes.size()) / static_cast<double>(files.size()));
    const auto* aim = shown_with(number, targets);
    if (is_new(aim, run.targets)) {
      target = read_run_target(aim->second);
      run.targets.push_back({aim->first, "target", pack(target)});
    }
    const auto* seen = shown_with(number, views);
    if (is_new(seen, run.views)) run.views.push_back({seen->first, read_run_views(seen->second)});
    run.meshes.push_back(read_frame(number, path, target));
  }
  return run;
}

Page read_runs_page(const std::vector<std::string>& folders, const RunPageOptions& options,
                    const Progress& progress) {
  Page page;
  for (const std::string& folder : folders) {
    page.runs.push_back(read_run_page(folder, options, progress));
    page.title += (page.title.empty() ? "" : ", ") + page.runs.back().name;
  }
  return page;
}

bool has_column(const Page& page, const std::string& name) {
  for (const PageRun& run : page.runs)
    for (const PageMesh& mesh : run.meshes)
      for (const PackedColumn& column : mesh.mesh.columns)
        if (column.name == name) return true;
  return false;
}

}  // namespace transformesh

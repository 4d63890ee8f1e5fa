#include "page/live_run.h"

#include <sys/stat.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>

#include "evolution/loop/run_folder.h"
#include "evolution/loop/stopwatch.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

/// Identifies one version of a file by inode and modification time. Empty if the file does not
/// exist.
std::string stamp_of(const std::string& path) {
  struct stat found {};
  if (stat(path.c_str(), &found) != 0) return {};
  return std::to_string(found.st_ino) + '-' + std::to_string(found.st_mtim.tv_sec) + '-' +
         std::to_string(found.st_mtim.tv_nsec);
}

/// False also if the file does not exist. Reading a FIFO would wait for its writer.
bool is_file(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

template <class What>
std::vector<What> in_order(const std::map<std::string, std::pair<std::string, What>>& known) {
  std::vector<What> ordered;
  ordered.reserve(known.size());
  for (const auto& [path, one] : known) ordered.push_back(one.second);
  std::ranges::stable_sort(ordered, {}, &What::number);
  return ordered;
}

}  // namespace

LiveRun::LiveRun(std::string folder) : folder_(std::move(folder)) {
  read_run(folder_);
  refresh(0);
}

void LiveRun::read_views() {
  Known<PageViews> present;
  for (const auto& [number, path] : run_views(folder_)) {
    const std::string stamp = stamp_of(path + run_file::cameras);
    const auto known = views_.find(path);
    if (known != views_.end() && known->second.first == stamp)
      present.insert(views_.extract(known));
    else
      present[path] = {stamp, {number, read_run_views(path)}};
  }
  views_ = std::move(present);
}

/// Reads and packs the target of an evolution, unless it is the file that was read last.
void LiveRun::read_target(std::size_t number, const std::string& path) {
  const std::string stamp = stamp_of(path);
  if (target_path_ == path + stamp) return;
  target_ = read_run_target(path);
  target_path_ = path + stamp;
  targets_[path] = {stamp, {number, "target", pack(target_), "target-" + stamp}};
}

/// Reads and packs a mesh. Returns nothing if a file cannot be read because it is being written or
/// removed, or because it is no regular file.
std::optional<PageMesh> LiveRun::read_mesh(std::size_t number, const std::string& path,
                                           const RunPaths::value_type* target) {
  if (!is_file(path) || (target != nullptr && !is_file(target->second))) return std::nullopt;
  try {
    if (target != nullptr) read_target(target->first, target->second);
    return read_frame(number, path, target != nullptr ? target_ : Mesh());
  } catch (const InputError&) {
    return std::nullopt;
  }
}

void LiveRun::read_meshes(double seconds) {
  const Stopwatch watch;
  const RunPaths targets = run_targets(folder_);
  Known<PageMesh> present, present_targets;
  for (const auto& [number, path] : run_mesh_files(folder_, run_.log)) {
    const auto* target = shown_with(number, targets);
    const std::string stamp =
        stamp_of(path) + (target != nullptr ? '-' + stamp_of(target->second) : "");
    const auto known = meshes_.find(path);
    if (known != meshes_.end() && known->second.first == stamp) {
      present.insert(meshes_.extract(known));
    } else if (watch.seconds() <= seconds) {
      std::optional<PageMesh> mesh = read_mesh(number, path, target);
      if (!mesh) continue;
      mesh->block = "mesh-" + std::to_string(number) + '-' + stamp;
      present[path] = {stamp, std::move(*mesh)};
    }
    if (target != nullptr && targets_.contains(target->second))
      present_targets.insert(targets_.extract(target->second));
  }
  meshes_ = std::move(present);
  targets_ = std::move(present_targets);
  run_.meshes = in_order(meshes_);
  run_.targets = in_order(targets_);
  run_.views = in_order(views_);
}

void LiveRun::refresh(double seconds) {
  try {
    PageRun run = read_run_texts(folder_);
    read_views();
    run_ = std::move(run);
  } catch (const InputError&) {
    return;  // the folder is being replaced by another run
  }
  read_meshes(seconds);
}

const std::string* LiveRun::block(const std::string& name) const {
  const PageBlocks blocks = page_blocks({&run_, 1});
  const auto found = std::ranges::find(blocks, name, &PageBlocks::value_type::first);
  return found != blocks.end() ? found->second : nullptr;
}

}  // namespace transformesh

#include "tm/page/live_run.h"

#include <sys/stat.h>

#include <algorithm>
#include <cstdint>

#include "tm/evolution/run_folder.h"
#include "tm/evolution/stopwatch.h"
#include "tm/support/error.h"

namespace transformesh {
namespace {

/// Another one when the file is; empty where there is none.
std::string stamp_of(const std::string& path) {
  struct stat found {};
  if (stat(path.c_str(), &found) != 0) return {};
  return std::to_string(found.st_ino) + '-' + std::to_string(found.st_mtim.tv_sec) + '-' +
         std::to_string(found.st_mtim.tv_nsec);
}

}  // namespace

LiveRun::LiveRun(std::string folder) : folder_(std::move(folder)) {
  read_run(folder_);
  refresh(0);
}

void LiveRun::read_texts() {
  PageRun texts = read_run_texts(folder_);
  texts.meshes = std::move(run_.meshes);
  texts.target = std::move(run_.target);
  run_ = std::move(texts);
}

void LiveRun::read_target() {
  const std::string stamp = stamp_of(folder_ + run_file::target);
  if (stamp == target_stamp_) return;
  target_ = read_run_target(folder_);
  run_.target.reset();
  if (!target_.positions.empty()) {
    run_.target = PageMesh{0, "target", pack(target_)};
    run_.target->block = "target-" + stamp;
  }
  target_stamp_ = stamp;
  known_.clear();
}

/// Empty where it cannot be read, as it is written or removed just now.
std::optional<PageMesh> LiveRun::read_mesh(std::size_t number, const std::string& path) const {
  try {
    return read_frame(number, path, &target_);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

void LiveRun::read_meshes(double seconds) {
  const Stopwatch watch;
  std::map<std::string, Known> present;
  for (const auto& [number, path] : run_mesh_files(folder_, run_.log)) {
    const std::string stamp = stamp_of(path);
    const auto known = known_.find(path);
    if (known != known_.end() && known->second.stamp == stamp) {
      present.insert(known_.extract(known));
    } else if (watch.seconds() <= seconds) {
      std::optional<PageMesh> mesh = read_mesh(number, path);
      if (!mesh) continue;
      mesh->block = "mesh-" + std::to_string(number) + '-' + stamp;
      present[path] = {stamp, std::move(*mesh)};
    }
  }
  known_ = std::move(present);
  run_.meshes.clear();
  for (const auto& [path, known] : known_) run_.meshes.push_back(known.mesh);
  std::ranges::stable_sort(run_.meshes, {}, &PageMesh::number);
}

void LiveRun::refresh(double seconds) {
  try {
    read_texts();
    read_target();
  } catch (const InputError&) {
    return;  // another run begins there just now
  }
  read_meshes(seconds);
}

const std::string* LiveRun::block(const std::string& name) const {
  if (run_.target && run_.target->block == name) return &run_.target->mesh.block;
  for (const auto& [path, known] : known_)
    if (known.mesh.block == name) return &known.mesh.mesh.block;
  for (std::size_t i = 0; i < run_.views.size(); ++i)
    if (photograph_name(0, i) == name) return &run_.views[i].photograph;
  return nullptr;
}

}  // namespace transformesh

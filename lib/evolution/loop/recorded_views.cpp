#include "evolution/loop/recorded_views.h"

#include <filesystem>
#include <optional>

#include "evolution/loop/run_folder.h"
#include "io/streams/streams.h"
#include "raster/middlebury.h"
#include "support/number.h"

namespace transformesh {
namespace {

struct PhotographName {
  std::size_t number = 0;
  int width = 0, height = 0;
};

std::optional<PhotographName> parse(const std::filesystem::path& path) {
  const std::string stem = path.stem().string();
  const std::size_t dash = stem.find('-'), cross = stem.find('x');
  if (path.extension() != ".png" || dash == std::string::npos || cross == std::string::npos ||
      cross < dash)
    return std::nullopt;
  const auto number = number_in<std::size_t>(stem.substr(0, dash));
  const auto width = number_in<int>(stem.substr(dash + 1, cross - dash - 1));
  const auto height = number_in<int>(stem.substr(cross + 1));
  if (!number || !width || !height || *width <= 0 || *height <= 0) return std::nullopt;
  return PhotographName{*number, *width, *height};
}

}  // namespace

std::vector<RunView> read_run_views(const std::string& folder) {
  std::vector<RunView> views;
  const std::string cameras = folder + run_file::cameras;
  if (!std::filesystem::exists(cameras)) return views;
  const Bytes bytes = read_all(cameras);
  for (CameraRecord& record : read_middlebury({bytes.view(), cameras}).cameras)
    views.push_back({std::move(record), {}});
  std::error_code ignored;
  for (const auto& entry :
       std::filesystem::directory_iterator(folder + run_file::photographs, ignored)) {
    const auto name = parse(entry.path());
    if (!name || name->number >= views.size()) continue;
    RunView& view = views[name->number];
    view.camera.width = name->width;
    view.camera.height = name->height;
    view.photograph = read_all(entry.path().string()).view();
  }
  return views;
}

}  // namespace transformesh

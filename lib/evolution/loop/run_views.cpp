#include "evolution/loop/run_views.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "io/streams/streams.h"
#include "support/number.h"
#include "transformesh/image.h"
#include "views/cameras/camera_file.h"
#include "views/cameras/view.h"
#include "views/images/image_file.h"

namespace transformesh {
namespace {

constexpr double most_pixels = 320;

std::string three_digits(std::size_t number) {
  const std::string digits = std::to_string(number);
  return std::string(3 - std::min<std::size_t>(digits.size(), 3), '0') + digits;
}

std::string photograph_name(std::size_t number, const GrayImage& image) {
  return std::string(run_file::photographs) + '/' + three_digits(number) + '-' +
         std::to_string(image.width) + 'x' + std::to_string(image.height) + ".png";
}

std::string small_picture(const GrayImage& image) {
  const double scale = std::max(1.0, std::max(image.width, image.height) / most_pixels);
  return write_png(picture_of(scale > 1 ? at_scale(image, scale) : image));
}

/// As a camera file can hold it, and as no other camera of the list is called.
std::string camera_name(const std::string& view, const CameraList& list) {
  std::string name = view.empty() ? "view" : view;
  std::ranges::replace_if(
      name, [](unsigned char c) { return c <= ' ' || c == 127 || c == '#'; }, '_');
  const auto is_taken = [&](const std::string& wanted) {
    return std::ranges::find(list.cameras, wanted, &CameraRecord::name) != list.cameras.end();
  };
  std::string unique = name;
  for (std::size_t i = 2; is_taken(unique); ++i) unique = name + '_' + std::to_string(i);
  return unique;
}

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

RunFiles run_files_of(std::span<const View> views, std::size_t step) {
  const std::string place = step > 0 ? run_name(run_file::views, step, "") : "";
  CameraList list;
  RunFiles files;
  for (const View& view : views) {
    if (!view.image.empty())
      files.emplace_back(place + photograph_name(list.cameras.size(), view.image),
                         small_picture(view.image));
    CameraRecord record;
    record.name = camera_name(view.name, list);
    record.camera = view.camera;
    list.cameras.push_back(std::move(record));
  }
  files.emplace_back(place + run_file::cameras, write_cameras(list, CameraFormat::middlebury));
  return files;
}

std::vector<RunView> read_run_views(const std::string& folder) {
  std::vector<RunView> views;
  const std::string cameras = folder + run_file::cameras;
  if (!std::filesystem::exists(cameras)) return views;
  for (CameraRecord& record : cameras_from(cameras).cameras)
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

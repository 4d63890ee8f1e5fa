#include "reconstruction/run_views.h"

#include <algorithm>

#include "transformesh/image.h"
#include "views/cameras/camera_file.h"
#include "views/cameras/camera_output.h"
#include "views/cameras/view.h"
#include "views/images/image_file.h"

namespace transformesh {
namespace {

/// Largest width and height of the stored photographs in pixels. Chosen by hand, to keep web pages
/// that contain them small.
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

/// Returns a name that camera files can store and that differs from all names in the list.
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

}  // namespace transformesh

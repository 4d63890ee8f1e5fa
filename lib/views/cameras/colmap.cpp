#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>

#include "views/cameras/camera_formats.h"

namespace transformesh {
namespace {

/// One camera of cameras.txt: intrinsics, and the size of the images that were taken with it.
struct ColmapLens {
  Eigen::Matrix3d intrinsics = Eigen::Matrix3d::Identity();
  LensDistortion distortion;
  int width = 0;
  int height = 0;
};
using Lenses = std::map<std::string, ColmapLens, std::less<>>;

bool is_model(std::string_view word) {
  return !word.empty() && word[0] >= 'A' && word[0] <= 'Z' &&
         word.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789") == std::string_view::npos;
}

bool next_data_row(TextRows& rows) {
  while (rows.next_row()) {
    if (!rows.peek().starts_with('#')) return true;
    rows.skip_row();
  }
  return false;
}

double read_parameter(TextRows& rows, const char* name, const std::string& who) {
  return rows.finite_number<double>([&] { return std::string(name) + " of " + who; });
}

int read_side(TextRows& rows, const char* name, const std::string& who) {
  const int side = rows.number<int>([&] { return std::string(name) + " of " + who; });
  if (side < 1) rows.fail(std::string(name) + " of " + who + " must be positive");
  return side;
}

/// A camera model of COLMAP, with the names of those parameters that follow cx and cy. Models
/// without `has_two_focals` have one focal length.
struct SupportedModel {
  std::string_view name;
  bool has_two_focals = false;
  std::string_view parameters;
};
constexpr std::array supported_models{SupportedModel{"SIMPLE_PINHOLE", false, ""},
                                      SupportedModel{"PINHOLE", true, ""},
                                      SupportedModel{"SIMPLE_RADIAL", false, "k1"},
                                      SupportedModel{"RADIAL", false, "k1k2"},
                                      SupportedModel{"OPENCV", true, "k1k2p1p2"},
                                      SupportedModel{"FULL_OPENCV", true, "k1k2p1p2k3k4k5k6"}};

double& parameter(LensDistortion& distortion, std::string_view name) {
  const auto index = static_cast<std::size_t>(name[1] - '1');
  return name[0] == 'k' ? distortion.radial[index] : distortion.tangential[index];
}

/// Reads one row of cameras.txt. Subtracts 0.5 from the principal point, because COLMAP's first
/// pixel center is (0.5, 0.5) and ours is (0, 0).
void read_colmap_lens(TextRows& rows, Lenses& lenses) {
  const std::string id(rows.word());
  const std::string who = "camera " + in_quotes(id);
  if (!rows.has_more()) rows.fail("the model of " + who + " is missing");
  const std::string name(rows.word());
  const auto* const model =
      std::find_if(supported_models.begin(), supported_models.end(),
                   [&](const SupportedModel& known) { return known.name == name; });
  if (model == supported_models.end()) {
    rows.fail(who + " has the model " + in_quotes(name) +
              ", whose distortion is not supported (SIMPLE_RADIAL, RADIAL, OPENCV and FULL_OPENCV "
              "are): undistort the images with colmap image_undistorter");
  }
  ColmapLens lens;
  lens.width = read_side(rows, "the width", who);
  lens.height = read_side(rows, "the height", who);
  Eigen::Matrix3d& k = lens.intrinsics;
  k(0, 0) = k(1, 1) = read_parameter(rows, "the focal length", who);
  if (model->has_two_focals) k(1, 1) = read_parameter(rows, "the second focal length", who);
  k(0, 2) = read_parameter(rows, "cx", who) - 0.5;
  k(1, 2) = read_parameter(rows, "cy", who) - 0.5;
  for (std::size_t i = 0; i < model->parameters.size(); i += 2) {
    const std::string word(model->parameters.substr(i, 2));
    parameter(lens.distortion, word) = read_parameter(rows, word.c_str(), who);
  }
  rows.end_row([&] { return std::string(who); });
  check_intrinsics(rows, k, who);
  if (!lenses.emplace(id, lens).second) rows.fail(who + " is listed twice");
}

Eigen::Matrix3d read_colmap_rotation(TextRows& rows, const std::string& who) {
  Eigen::Quaterniond rotation;
  rotation.w() = read_parameter(rows, "qw", who);
  rotation.x() = read_parameter(rows, "qx", who);
  rotation.y() = read_parameter(rows, "qy", who);
  rotation.z() = read_parameter(rows, "qz", who);
  if (std::abs(rotation.norm() - 1) > 1e-3) {
    rows.fail("the quaternion of " + who + " has length " + std::to_string(rotation.norm()) +
              " instead of 1");
  }
  return rotation.normalized().toRotationMatrix();
}

CameraRecord read_image(TextRows& rows, const Source& source, const Lenses& lenses) {
  CameraRecord record;
  record.place = place_of(rows, source);
  const std::string who = "image " + in_quotes(rows.word());
  record.camera.rotation = read_colmap_rotation(rows, who);
  for (int i = 0; i < 3; ++i) {
    constexpr std::array names{"tx", "ty", "tz"};
    record.camera.translation[i] = read_parameter(rows, names[static_cast<std::size_t>(i)], who);
  }
  check_translation(rows, record.camera.translation, who);
  if (!rows.has_more()) rows.fail("the camera of " + who + " is missing");
  const std::string_view id = rows.word();
  const auto lens = lenses.find(id);
  if (lens == lenses.end())
    rows.fail("there is no camera " + in_quotes(id) + ", to which " + who + " refers");
  record.camera.intrinsics = lens->second.intrinsics;
  record.distortion = lens->second.distortion;
  record.width = lens->second.width;
  record.height = lens->second.height;
  record.name = rows.skip_row();
  if (record.name.empty()) rows.fail("the name of " + who + " is missing");
  return record;
}

/// Skips the second line of an image in images.txt, which contains observed points. The line may be
/// empty, or missing at the end of the file.
void skip_points(TextRows& rows, const Source& source, const std::string& name) {
  const char* line = rows.rest();
  const char* end = std::find(line, source.end(), '\n');
  const bool is_blank =
      std::all_of(line, end, [](char c) { return c == ' ' || c == '\r' || c == '\t'; });
  if (is_blank || !rows.next_row()) return;
  const std::size_t words = rows.words_left();
  bool are_points = words % 3 == 0;
  while (are_points && rows.has_more()) are_points = is_number(rows.word());
  if (!are_points) {
    rows.fail("a line of points x y id, which may be empty, must follow the line of " +
              in_quotes(name));
  }
}

CameraList read_images(TextRows& rows, const Source& source, const Lenses& lenses) {
  CameraList list;
  list.names_images = true;
  do {
    list.cameras.push_back(read_image(rows, source, lenses));
    skip_points(rows, source, list.cameras.back().name);
  } while (next_data_row(rows));
  return list;
}

/// True if the current row is a row of cameras.txt.
bool at_lens(const TextRows& rows) { return colmap_section(rows) == ColmapSection::cameras; }

[[noreturn]] void fail_without_images(const TextRows& rows) {
  rows.fail("there is no image in COLMAP's images.txt, so no camera has a pose");
}

Lenses read_lenses(const Source& source) {
  TextRows rows(source, 0, rules_without_comments);
  Lenses lenses;
  while (next_data_row(rows)) read_colmap_lens(rows, lenses);
  return lenses;
}

}  // namespace

ColmapSection colmap_section(TextRows rows) {
  rows.word();
  if (is_model(rows.peek())) {
    rows.word();
    const bool has_size = is_number(rows.word()) && is_number(rows.word());
    return has_size ? ColmapSection::cameras : ColmapSection::none;
  }
  for (int i = 1; i < 9; ++i) {
    if (!is_number(rows.word())) return ColmapSection::none;
  }
  return rows.has_more() && !is_number(rows.word()) ? ColmapSection::images : ColmapSection::none;
}

CameraList read_colmap(const Source& cameras, const Source& images) {
  const Lenses lenses = read_lenses(cameras);
  TextRows rows(images, 0, rules_without_comments);
  if (!next_data_row(rows)) fail_without_images(rows);
  return read_images(rows, images, lenses);
}

CameraList read_colmap(const Source& source) {
  TextRows rows(source, 0, rules_without_comments);
  Lenses lenses;
  bool has_row = next_data_row(rows);
  for (; has_row && at_lens(rows); has_row = next_data_row(rows)) read_colmap_lens(rows, lenses);
  if (!has_row) fail_without_images(rows);
  return read_images(rows, source, lenses);
}

}  // namespace transformesh

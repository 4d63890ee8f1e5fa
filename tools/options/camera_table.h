/// The table of tm-cameras --list: one line, or one JSON object, for each camera.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "views/cameras/camera_file.h"
#include "views/cameras/view_pairs.h"

namespace transformesh::tool {

struct CameraTable {
  CameraList list;
  Vec3 scene_center = Vec3::Zero();
  /// Median over the cameras of the size of a pixel at the scene's center. Empty if the center is
  /// behind all cameras.
  std::optional<double> pixel_size;
  std::vector<ViewPair> pairs;
  /// True if there is a single camera and no center is given, so that the center is assumed to be
  /// one unit in front of the camera.
  bool is_center_assumed = false;
};

/// Returns the table. The scene's center is `center` if it has three numbers, otherwise the point
/// closest to all viewing axes. Throws InputError for a camera whose focal length is relative to an
/// unknown image size.
CameraTable table_of(CameraList list, const std::vector<double>& center, std::size_t neighbors);

/// Returns the table as text, with aligned columns under a line with their names.
std::string text_of(const CameraTable& table);
std::string json_of(const CameraTable& table);

}  // namespace transformesh::tool

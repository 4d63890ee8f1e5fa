/// The table of tm-cameras --list: a line, or a JSON object, per camera.
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
  /// Median pixel size at the scene's center; nothing if no camera has the center in front of it.
  std::optional<double> pixel_size;
  std::vector<ViewPair> pairs;
  bool is_center_assumed = false;  ///< the center is one unit in front of a single camera
};

/// Returns the table. The scene's center is `center` if that has three numbers, otherwise the point
/// closest to all viewing axes. Throws InputError for a camera whose focal length is relative to an
/// unknown image size.
CameraTable table_of(CameraList list, const std::vector<double>& center, std::size_t neighbors);

/// Returns aligned columns under a line with their names.
std::string text_of(const CameraTable& table);
std::string json_of(const CameraTable& table);

}  // namespace transformesh::tool

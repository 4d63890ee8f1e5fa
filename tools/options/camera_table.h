/// What tm-cameras --list prints: a line, or an object of JSON, for each camera.
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
  /// The median at the scene's center; nothing if no camera has the center in front of it.
  std::optional<double> pixel_size;
  std::vector<ViewPair> pairs;
  bool is_center_assumed = false;  ///< one unit in front of a single camera
};

/// The scene's center is `center` if that has three numbers, else the point nearest to all viewing
/// axes. Throws InputError for a camera whose focal length needs the size of its image.
CameraTable table_of(CameraList list, const std::vector<double>& center, std::size_t neighbors);

/// Columns under a line of their names.
std::string text_of(const CameraTable& table);
std::string json_of(const CameraTable& table);

}  // namespace transformesh::tool

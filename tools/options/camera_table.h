/// What tm-cameras --list prints: a line, or an object of JSON, for each camera.
#pragma once

#include <string>

#include "views/cameras/camera_file.h"
#include "views/cameras/view_pairs.h"

namespace transformesh::tool {

struct CameraTable {
  CameraList list;
  Vec3 scene_center = Vec3::Zero();
  double pixel_size = 0;  ///< the median at the scene's center
  std::vector<ViewPair> pairs;
};

/// Columns under a line of their names.
std::string text_of(const CameraTable& table);
std::string json_of(const CameraTable& table);

}  // namespace transformesh::tool

/// Synthetic views of a textured mesh, rendered as tm-photograph does.
#pragma once

#include <string>
#include <vector>

#include "views/cameras/camera_ring.h"
#include "views/cameras/view.h"
#include "views/photo/photograph.h"

namespace transformesh::test {

/// Returns a ring of cameras around the origin. Objects of radius 1 fill most of the 96x72 images.
inline CameraRing small_ring(int count = 10) {
  CameraRing ring;
  ring.count = count;
  ring.width = 96;
  ring.height = 72;
  ring.focal_length = 330;
  ring.distance = 10.5;
  return ring;
}

/// Returns a view per camera, with photograph and mask.
inline std::vector<View> photographed(const Mesh& mesh, const CameraRing& ring = small_ring()) {
  const SolidTexture texture({.waves = 40, .finest = 0.2, .coarsest = 1});
  std::vector<View> views;
  for (const CameraRecord& record : camera_ring(ring).cameras) {
    const Camera camera{record.camera.projection(), record.width, record.height};
    Photograph photograph = take_photograph(mesh, camera, texture, views.size());
    views.push_back({record.name, record.camera, std::move(photograph.image),
                     std::move(photograph.silhouette)});
  }
  return views;
}

inline std::vector<View> without_masks(std::vector<View> views) {
  for (View& view : views) view.silhouette = GrayImage();
  return views;
}

}  // namespace transformesh::test

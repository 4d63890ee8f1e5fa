#include "tm/views/photo/photo_scene.h"

#include "tm/support/counted.h"
#include "tm/support/error.h"
#include "tm/support/parallel.h"
#include "tm/views/cameras/pinhole_camera.h"
#include "tm/views/cameras/view.h"
#include "tm/views/hull/contour_distance.h"

namespace transformesh {

PhotoScene photo_scene(std::span<const View> views, double scale, const PairOptions& pairs) {
  PhotoScene scene;
  const std::vector<PinholeCamera> cameras = cameras_of(views);
  const Vec3 center = viewed_point(cameras);
  scene.pairs = choose_pairs(cameras, center, pairs);
  if (scene.pairs.empty()) {
    throw InputError("no two of " + counted(views.size(), "view") +
                     " are as far apart as views that are compared must be");
  }
  scene.pixel = scale * pixel_size(cameras, center);
  scene.views.resize(views.size());
  scene.distances.resize(views.size());
  parallel_for(views.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      scene.views[i] = at_scale(views[i], scale);
      if (!scene.views[i].silhouette.empty())
        scene.distances[i] = signed_distance(scene.views[i].silhouette);
      if (views[i].image.is_packed()) scene.distances[i].pack(HeldImage::Kind::distances);
      scene.views[i].silhouette = HeldImage();
    }
  });
  return scene;
}

}  // namespace transformesh

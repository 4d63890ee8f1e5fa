#include "views/photo/photo_scene.h"

#include <functional>
#include <utility>

#include "support/counted.h"
#include "support/parallel.h"
#include "transformesh/errors.h"
#include "transformesh/pinhole_camera.h"
#include "views/cameras/view.h"
#include "views/hull/contour_distance.h"

namespace transformesh {
namespace {

/// A function that reduces view `i` and adds it to the scene.
using AddView = std::function<void(std::size_t i, PhotoScene& scene)>;

void add_view_to_scene(const View& view, std::size_t i, double scale, PhotoScene& scene) {
  scene.views[i] = at_scale(view, scale);
  PackableImage silhouette = std::exchange(scene.views[i].silhouette, PackableImage());
  if (!silhouette.empty()) scene.distances[i] = signed_distance(silhouette);
  if (view.image.is_packed()) scene.distances[i].pack(PackableImage::Kind::distances);
}

PhotoScene make_scene(std::span<const View> views, double scale, const PairOptions& pairs,
                      const AddView& add) {
  PhotoScene scene;
  const std::vector<PinholeCamera> cameras = cameras_of(views);
  const Vec3 center = viewed_point(cameras);
  scene.pairs = choose_pairs(cameras, center, pairs);
  if (scene.pairs.empty()) {
    throw InputError("no two of " + counted(views.size(), "view") +
                     " have an angle between them that allows a comparison: allow other angles");
  }
  scene.pixel = scale * pixel_size(cameras, center);
  scene.views.resize(views.size());
  scene.distances.resize(views.size());
  parallel_for(views.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) add(i, scene);
  });
  return scene;
}

}  // namespace

PhotoScene photo_scene(std::span<const View> views, double scale, const PairOptions& pairs) {
  return make_scene(views, scale, pairs, [&](std::size_t i, PhotoScene& scene) {
    add_view_to_scene(views[i], i, scale, scene);
  });
}

PhotoScene take_photo_scene(std::span<View> views, double scale, const PairOptions& pairs) {
  return make_scene(views, scale, pairs, [&](std::size_t i, PhotoScene& scene) {
    add_view_to_scene(views[i], i, scale, scene);
    views[i].image = views[i].silhouette = PackableImage();
  });
}

}  // namespace transformesh

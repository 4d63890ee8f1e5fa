#include "tm/views/photo/photo_scene.h"

#include "tm/support/counted.h"
#include "tm/support/error.h"
#include "tm/support/number.h"
#include "tm/support/parallel.h"
#include "tm/views/cameras/pinhole_camera.h"
#include "tm/views/cameras/view.h"
#include "tm/views/hull/contour_distance.h"

namespace transformesh {
namespace {

template <typename Done>
PhotoScene make_scene(std::span<const View> views, double scale, const PairOptions& pairs,
                      const Done& done) {
  PhotoScene scene;
  const std::vector<PinholeCamera> cameras = cameras_of(views);
  const Vec3 center = viewed_point(cameras);
  scene.pairs = choose_pairs(cameras, center, pairs);
  if (scene.pairs.empty()) {
    throw InputError("no two of " + counted(views.size(), "view") + " are " +
                     shortest_text(pairs.minimum_angle_deg) + " to " +
                     shortest_text(pairs.maximum_angle_deg) +
                     " degrees apart, as views that are compared must be: see --max-angle");
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
      done(i);
    }
  });
  return scene;
}

}  // namespace

PhotoScene photo_scene(std::span<const View> views, double scale, const PairOptions& pairs) {
  return make_scene(views, scale, pairs, [](std::size_t) {});
}

PhotoScene take_photo_scene(std::vector<View>& views, double scale, const PairOptions& pairs) {
  return make_scene(views, scale, pairs,
                    [&](std::size_t i) { views[i].image = views[i].silhouette = HeldImage(); });
}

}  // namespace transformesh

#include "tm/views/depth/opened_hull.h"

#include <algorithm>

#include "tm/support/parallel.h"
#include "tm/views/cameras/pinhole_camera.h"

namespace transformesh {
namespace {

std::vector<View> shrunk(std::span<const View> views, double scale) {
  std::vector<View> result(views.size());
  parallel_for(views.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      View view{views[i].name, views[i].camera, views[i].image, HeldImage()};
      result[i] = at_scale(view, scale);
    }
  });
  return result;
}

/// Of the nodes inside the hull, the share of those that are open and as deep as values say.
double deep_share(const ValueGrid& hull, const ValueGrid& opened) {
  const float deepest = *std::min_element(hull.values.begin(), hull.values.end());
  std::size_t inside = 0;
  std::size_t deep = 0;
  for (std::size_t i = 0; i < hull.values.size(); ++i) {
    if (hull.values[i] < 0) ++inside;
    if (hull.values[i] <= deepest && opened.values[i] >= 0) ++deep;
  }
  return inside > 0 ? static_cast<double>(deep) / static_cast<double>(inside) : 0;
}

}  // namespace

std::optional<OpenedHull> opened_hull(std::span<const View> views, const OpenedHullOptions& options,
                                      const Progress& progress) {
  const std::vector<PinholeCamera> cameras = cameras_of(views);
  const Vec3 center = viewed_point(cameras);
  const double pixel = pixel_size(cameras, center);
  const Box box = silhouette_box(views);
  const double length_px = (box.maximum - box.minimum).maxCoeff() / pixel;
  const double scale = std::max(1.0, length_px / options.size_px);

  const ValueGrid hull =
      hull_values(views, {.box = box, .edge = options.cell_px * scale * pixel}, progress);
  const std::vector<ViewPair> pairs = choose_pairs(cameras, center, options.pairs);
  const std::vector<View> small = shrunk(views, scale);
  const std::vector<DepthMap> maps = depth_maps(small, pairs, hull, options.maps, progress);
  const ValueGrid opened = fuse_depths(hull, small, maps, options.fusion, progress);
  if (deep_share(hull, opened) < options.least_share) return std::nullopt;
  OpenedHull result{march_tetrahedra(opened), scale};
  drop_components(result.mesh, options.keep);
  if (result.mesh.faces.empty()) return std::nullopt;
  return result;
}

}  // namespace transformesh

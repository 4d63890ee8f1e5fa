#include "views/depth/opened_hull.h"

#include <algorithm>
#include <numeric>

#include "transformesh/pinhole_camera.h"
#include "views/cameras/view.h"
#include "views/hull/hull_values.h"
#include "views/hull/needed_components.h"
#include "views/hull/silhouette.h"

namespace transformesh {
namespace {

/// `hull`: a visual hull as values on a grid. `opened`: the same hull after depth maps of
/// photographs, shrunk by `scale`, have opened its hollows by fuse_depths().
struct Opening {
  ValueGrid hull, opened;
  double scale;

  double deep_share() const;
};

/// Returns the fraction of the hull's volume that is removed deep inside: grid nodes outside of the
/// opened hull, divided by all nodes inside the hull. A removed node counts if its value in the
/// hull is the minimum of all values. Values are clamped at four cells, so many nodes share this
/// minimum.
double Opening::deep_share() const {
  const float deepest = *std::min_element(hull.values.begin(), hull.values.end());
  std::size_t inside = 0;
  std::size_t deep = 0;
  for (std::size_t i = 0; i < hull.values.size(); ++i) {
    if (hull.values[i] < 0) ++inside;
    if (hull.values[i] <= deepest && opened.values[i] >= 0) ++deep;
  }
  return inside > 0 ? static_cast<double>(deep) / static_cast<double>(inside) : 0;
}

Opening open_at(double size_px, std::span<const View> views, const OpenedHullOptions& options,
                const Progress& progress) {
  const std::vector<PinholeCamera> cameras = cameras_of(views);
  const Vec3 center = viewed_point(cameras);
  const double pixel = pixel_size(cameras, center);
  const Box box = silhouette_box(views);
  const double scale = std::max(1.0, (box.max() - box.min()).maxCoeff() / pixel / size_px);

  Opening opening{
      hull_values(views, {.box = box, .edge = options.cell_px * scale * pixel}, progress),
      {},
      scale};
  DepthMapsOptions maps = options.maps;
  maps.sweep.correlation.noise_variance /= scale * scale;
  const std::vector<ViewPair> pairs = choose_pairs(cameras, center, options.pairs);
  const std::vector<View> small = shrunk_photographs(views, scale);
  const std::vector<DepthMap> depths = depth_maps(small, pairs, opening.hull, maps, progress);
  opening.opened = fuse_depths(opening.hull, small, depths, options.fusion, progress);
  return opening;
}

/// Returns the intersection over union of the silhouettes of mesh and views, averaged over the
/// views.
double mean_agreement(const Mesh& mesh, std::span<const View> views) {
  const std::vector<double> agreements = silhouette_agreements(mesh, views);
  return std::accumulate(agreements.begin(), agreements.end(), 0.0) /
         static_cast<double>(agreements.size());
}

}  // namespace

std::optional<OpenedHull> opened_hull(std::span<const View> views, const OpenedHullOptions& options,
                                      const Progress& progress) {
  Opening opening = open_at(options.trial_px, views, options, progress);
  if (opening.deep_share() < options.least_share) return std::nullopt;
  if (opening.scale > 1) opening = open_at(options.size_px, views, options, progress);
  OpenedHull result{march_tetrahedra(opening.opened), opening.scale};
  if (options.keep)
    drop_components(result.mesh, *options.keep);
  else
    drop_unneeded_components(result.mesh, views);
  if (result.mesh.faces.empty()) return std::nullopt;
  const double before = mean_agreement(march_tetrahedra(opening.hull), views);
  if (mean_agreement(result.mesh, views) < before - options.most_agreement_lost)
    return std::nullopt;
  return result;
}

}  // namespace transformesh

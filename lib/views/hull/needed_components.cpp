#include "views/hull/needed_components.h"

#include <algorithm>
#include <vector>

#include "raster/camera.h"
#include "raster/rasterize.h"
#include "support/parallel.h"
#include "transformesh/components.h"

namespace transformesh {
namespace {

/// Components are compared in views whose larger side is shrunk to at most this many pixels, which
/// limits the time. Chosen by hand; not measured.
constexpr double most_side_px = 320;
/// A component is needed if more than this fraction of its pixels is not covered by larger needed
/// components. Hulls of coarse cells leave a rim of the silhouettes uncovered. Phantoms, components
/// that are no part of the object, may cover parts of this rim. Parts of the object that are
/// visible in half of the views have more than half of their pixels uncovered there. Lower values
/// keep phantoms; higher values drop parts of the object that others often hide.
constexpr double least_uncovered = 0.1;
/// Components with less than this fraction of the largest volume are dropped. Reconstructions drop
/// such components at their end in any case (ReconstructionOptions::crumbs).
constexpr double least_volume_share = 0.001;

Camera small_camera(const View& view) {
  const PackableImage& image = view.image.empty() ? view.silhouette : view.image;
  const double scale = std::max(1.0, std::max(image.width, image.height) / most_side_px);
  return {view.camera.shrunk(scale).projection(), static_cast<int>(image.width / scale),
          static_cast<int>(image.height / scale)};
}

/// The pixels of all views that are covered by the components that were found to be needed.
class CoveredPixels {
 public:
  explicit CoveredPixels(std::span<const View> views) {
    for (const View& view : views) {
      cameras_.push_back(small_camera(view));
      covered_.emplace_back(cameras_.back().width, cameras_.back().height);
    }
  }

  /// Returns the fraction of the pixels of `mesh`, over all views, that were not covered before.
  /// Marks the pixels of `mesh` as covered if this fraction is above `limit`.
  double add(const Mesh& mesh, double limit) {
    std::vector<Raster<char>> before = covered_;
    std::vector<std::size_t> shown(cameras_.size(), 0), fresh(cameras_.size(), 0);
    parallel_for(cameras_.size(), 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const FaceBuffer faces = rasterize(mesh, cameras_[i]);
        for (std::size_t pixel = 0; pixel < faces.pixels.size(); ++pixel) {
          if (faces.pixels[pixel].face == no_index) continue;
          ++shown[i];
          fresh[i] += covered_[i].pixels[pixel] == 0 ? 1 : 0;
          covered_[i].pixels[pixel] = 1;
        }
      }
    });
    std::size_t all = 0, uncovered = 0;
    for (std::size_t i = 0; i < shown.size(); ++i) {
      all += shown[i];
      uncovered += fresh[i];
    }
    const double share = all > 0 ? static_cast<double>(uncovered) / static_cast<double>(all) : 0;
    if (!(share > limit)) covered_ = std::move(before);
    return share;
  }

 private:
  std::vector<Camera> cameras_;
  std::vector<Raster<char>> covered_;
};

/// Returns the components of positive volume, the largest first, without those below
/// `least_volume_share`.
std::vector<Index> candidates(const std::vector<Component>& components) {
  double largest = 0;
  for (const Component& component : components) largest = std::max(largest, component.volume);
  std::vector<Index> order;
  for (Index i = 0; i < components.size(); ++i)
    if (components[i].volume > 0 && components[i].volume >= least_volume_share * largest)
      order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return components[a].volume > components[b].volume; });
  return order;
}

Mesh faces_of(const Mesh& mesh, const Components& parts, const std::vector<bool>& keeps) {
  std::vector<bool> keeps_face;
  for (const Index part : parts.of_face) keeps_face.push_back(keeps[part]);
  return select_faces(mesh, keeps_face);
}

}  // namespace

std::size_t drop_unneeded_components(Mesh& mesh, std::span<const View> views) {
  const Components parts = connected_components(mesh);
  CoveredPixels covered(views);
  std::vector<bool> needed(parts.components.size(), false);
  std::size_t kept = 0;
  for (const Index part : candidates(parts.components)) {
    std::vector<bool> alone(parts.components.size(), false);
    alone[part] = true;
    needed[part] = covered.add(faces_of(mesh, parts, alone), least_uncovered) > least_uncovered;
    kept += needed[part] ? 1 : 0;
  }
  mesh = faces_of(mesh, parts, needed);
  return parts.components.size() - kept;
}

}  // namespace transformesh

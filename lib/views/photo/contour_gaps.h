/// Distances of a surface from the silhouettes that it should have.
///
/// A vertex outside any silhouette is outside the object. A vertex on the rim of the surface in a
/// view borders on the background in that view, and should lie on the contour of the silhouette. A
/// vertex has no distance in views that do not contain it, and none to silhouettes without a
/// contour.
#pragma once

#include <span>
#include <vector>

#include "transformesh/hull.h"
#include "views/cameras/view.h"
#include "views/photo/visible_surface.h"

namespace transformesh {

/// Per vertex. Lengths are in input units.
struct ContourGaps {
  /// Largest distance outside of a silhouette over all views; 0 if the vertex is inside all
  /// silhouettes.
  std::vector<double> outside;
  /// Sum of the distances from the contour, over views in which the vertex is on the rim of the
  /// surface and inside the silhouette.
  std::vector<double> inside;
  std::vector<Index> rims;  ///< number of views over which `inside` is summed
};

/// Measures the gaps of `mesh`. `distances` are signed_distance() of the silhouettes, empty for
/// views without silhouette. `seen` must be made of `mesh` and `views`. If silhouettes are lower
/// bounds (SilhouetteMeaning::least), `outside` is 0, and `inside` only counts gaps beyond one
/// pixel. O(views * vertices); deterministic.
ContourGaps contour_gaps(const Mesh& mesh, std::span<const View> views, const SeenViews& seen,
                         std::span<const PackableImage> distances,
                         SilhouetteMeaning meaning = SilhouetteMeaning::exact);

}  // namespace transformesh

/// Computes distances of the vertices of a surface from the silhouettes that the surface should
/// have.
///
/// If the image of a vertex is outside the silhouette of any view, the vertex is outside the
/// object. A vertex is on the rim of the surface in a view if it borders on the background there.
/// It should then lie on the contour of the silhouette. A vertex has no distance in views that do
/// not contain it, and in views whose silhouette has no contour.
#pragma once

#include <span>
#include <vector>

#include "transformesh/hull.h"
#include "views/cameras/view.h"
#include "views/photo/visible_surface.h"

namespace transformesh {

/// Distances for each vertex, in input units.
struct ContourGaps {
  /// Largest distance by which the vertex is outside of a silhouette, over all views; 0 if it is
  /// inside all silhouettes.
  std::vector<double> outside;
  /// Sum of the distances from the contour, over views in which the vertex is on the rim of the
  /// surface and inside the silhouette.
  std::vector<double> inside;
  std::vector<Index> rims;  ///< number of views over which `inside` is summed
};

/// Measures the distances of the vertices of `mesh`. `distances` are signed_distance() of the
/// silhouettes, empty for views without silhouette. `seen` must be made of `mesh` and `views`. If
/// `meaning` is SilhouetteMeaning::least, the object may be larger than its silhouettes: `outside`
/// is 0, and one pixel is subtracted from distances in `inside`. O(views * vertices);
/// deterministic.
ContourGaps contour_gaps(const Mesh& mesh, std::span<const View> views, const SeenViews& seen,
                         std::span<const PackableImage> distances,
                         SilhouetteMeaning meaning = SilhouetteMeaning::exact);

}  // namespace transformesh

/// How far a surface is from the silhouettes that it should have.
///
/// A vertex outside any silhouette is outside the object. A vertex on the rim of the surface in a
/// view, where it borders on the background, should lie on the silhouette's contour there. Places
/// beyond an image, and silhouettes without a contour, say nothing.
#pragma once

#include <span>
#include <vector>

#include "transformesh/hull.h"
#include "views/cameras/view.h"
#include "views/photo/visible_surface.h"

namespace transformesh {

/// Per vertex; lengths in input units.
struct ContourGaps {
  std::vector<double> outside;  ///< how far it is outside, in the view where that is most; or 0
  std::vector<double> inside;   ///< how far the contour is beyond it, summed over views
  std::vector<Index> rims;      ///< number of views in that sum
};

/// `distances` are signed_distance() of the views' silhouettes, empty where there is none. `seen`
/// is of mesh and views. O(views * vertices); deterministic.
ContourGaps contour_gaps(const Mesh& mesh, std::span<const View> views, const SeenViews& seen,
                         std::span<const PackableImage> distances,
                         SilhouetteMeaning meaning = SilhouetteMeaning::exact);

}  // namespace transformesh

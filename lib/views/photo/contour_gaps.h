/// How far a surface is from the silhouettes that it should have.
///
/// A vertex outside any silhouette is outside the object. A vertex on the rim of the surface in a
/// view, where it borders on the background, should lie on the silhouette's contour there. Places
/// beyond an image, and silhouettes without a contour, say nothing.
#pragma once

#include <span>
#include <vector>

#include "views/photo/visible_surface.h"

namespace transformesh {

/// What silhouettes say of the object: where it is and where not; or, as those do that a threshold
/// found, only where some of it is, to within a pixel. Then nothing is outside, and a rim is beyond
/// the contour only from a pixel on.
enum class SilhouetteMeaning { exact, least };

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

/// Exact hidden-line removal: computes the visible parts of segments without rasterization.
/// Reference: Appel, "The notion of quantitative invisibility and the machine rendering of solids",
/// ACM National Conference 1967. Unlike in this reference, a Bvh of projected faces yields the
/// faces in front of a line.
///
/// A face hides the points behind its plane in the cone from the camera through the face. For a
/// segment, these are the points where four linear functions are positive, which form one interval.
/// A face does not hide points that are behind it by less than 1e-6 of its distance, so that lines
/// on a surface are visible. Cost: O(faces) to build, O(log faces + overlapping boxes) per segment.
/// Deterministic; thread-safe.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "geometry/search/bvh.h"
#include "raster/camera.h"
#include "raster/rasterize.h"
#include "transformesh/mesh.h"

namespace transformesh {

class VisibleLines {
 public:
  /// Keeps no reference to `mesh` or `camera`. Faces of both orientations hide segments.
  VisibleLines(const Mesh& mesh, const Camera& camera);

  /// Returns the visible parts of a segment in the image, as ascending, disjoint intervals in [0,
  /// 1] from its start to its end. The faces `own`, which contain the segment, do not hide it.
  using Parts = std::vector<std::pair<double, double>>;
  Parts parts(const Vec3& from, const Vec3& to, std::span<const Index> own = {}) const;

 private:
  Camera camera_;
  std::vector<EdgeFunctions> faces_;
  Bvh bvh_;  ///< boxes of the projected faces: pixels and depths
};

}  // namespace transformesh

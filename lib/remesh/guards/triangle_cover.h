/// Certifies that all points of a triangle are within a distance of a surface.
///
/// The distance from a convex set, such as a face, is a convex function. If the three corners of a
/// triangle are within the distance of one face, then all points of the triangle are. A triangle
/// without such a face is cut in two parts, which are certified separately. The cut is where an
/// edge passes from the face near one end to the face near the other end. Therefore a triangle is
/// cut about as often as edges of the surface cross it, for any distance. Since the number of cuts
/// is limited, the certificate may not be found, but it is never wrong.
#pragma once

#include <cmath>

#include "mesh/triangle.h"

namespace transformesh {

/// A corner of a triangle, and a face of the surface within the distance of the corner.
struct CoverCorner {
  Vec3 point;
  Index face = no_index;
};
using CoverTriangle = std::array<CoverCorner, 3>;

/// Certifies triangles. `Surface` is the set of faces and has these functions:
/// - `limit()` returns the square of the distance.
/// - `squared_distance(point, face)` is measured to the approximately closest point of the face.
/// - `nearest(point, hint)` returns a face within the distance of the point, or no_index.
/// - `near_all(corners)` returns a face within the distance of all three corners, or no_index.
template <class Surface>
class TriangleCover {
 public:
  TriangleCover(Surface& surface, std::size_t most_cuts) : surface_(surface), cuts_(most_cuts) {}

  /// True if the triangle is certified. First finds a face for each corner without one.
  bool covers(CoverTriangle corners) {
    for (CoverCorner& corner : corners) {
      if (corner.face == no_index) corner.face = surface_.nearest(corner.point, corners[0].face);
      if (corner.face == no_index) return false;
    }
    return covers(corners, most_levels);
  }
  std::size_t cuts_left() const { return cuts_; }

 private:
  /// Largest number of consecutive cuts. Rounding moves a point by at most two spacings in each
  /// cut, and by 32 spacings in all cuts, as `rounding_share` in error_bound.cpp assumes. Twice as
  /// many levels certify no more triangles of folded and noisy shapes.
  static constexpr int most_levels = 16;

  bool covers(const CoverTriangle& corners, int levels) {
    if (surface_.near_all(corners) != no_index) return true;
    if (levels == 0 || cuts_ == 0) return false;
    --cuts_;
    const auto [edge, share] = find_cut(corners);
    const CoverCorner &from = corners[edge], &to = corners[(edge + 1) % 3];
    CoverCorner cut{from.point + share * (to.point - from.point)};
    cut.face = surface_.nearest(cut.point, from.face);
    if (cut.face == no_index) return false;
    CoverTriangle first = corners, second = corners;
    first[(edge + 1) % 3] = cut;
    second[edge] = cut;
    return covers(first, levels - 1) && covers(second, levels - 1);
  }

  struct Cut {
    std::size_t edge = 0;
    double share = 0.5;  ///< fraction of the edge before the cut
  };

  /// Returns a cut on the longest edge whose ends are both not near the face of the other end. If
  /// there is no such edge, returns the middle of the longest edge.
  Cut find_cut(const CoverTriangle& corners) const {
    Cut cut, middle;
    double longest = -1, longest_of_all = -1;
    for (std::size_t i = 0; i < 3; ++i) {
      const CoverCorner &from = corners[i], &to = corners[(i + 1) % 3];
      const double length = (to.point - from.point).squaredNorm();
      if (length > longest_of_all) middle.edge = i, longest_of_all = length;
      if (length <= longest || from.face == to.face) continue;
      const double there = surface_.squared_distance(from.point, to.face);
      const double back = surface_.squared_distance(to.point, from.face);
      if (there <= surface_.limit() || back <= surface_.limit()) continue;
      longest = length;
      const double rises = std::sqrt(there);
      cut = {i, rises / (rises + std::sqrt(back))};
    }
    return longest < 0 ? middle : cut;
  }

  Surface& surface_;
  std::size_t cuts_;
};

}  // namespace transformesh

/// Certifies that all points of a triangle are within a distance of a surface.
///
/// The distance from a convex set, such as a face, is a convex function. If the three corners of a
/// triangle are within the distance of one face, then all of its points are. A triangle without
/// such a face is cut in two, and each part is certified by itself. The cut is where the edge
/// between two corners passes from the face near one of them to the face near the other. So a
/// triangle is cut about as often as edges of the surface cross it, however small the distance is.
/// The certificate may be missed, as there is a largest number of cuts, but it is never wrong.
#pragma once

#include <cmath>

#include "mesh/triangle.h"

namespace transformesh {

/// A corner of a triangle with a face of the surface that is within the distance of the corner.
struct CoverCorner {
  Vec3 point;
  Index face = no_index;
};
using CoverTriangle = std::array<CoverCorner, 3>;

/// `Surface` is the set of faces. Its `limit()` is the square of the distance.
/// `squared_distance(point, face)` is from a point of the face that is about the closest.
/// `nearest(point, hint)` is a face within the distance of the point, or no_index.
/// `near_all(corners)` is a face within the distance of all three corners, or no_index.
template <class Surface>
class TriangleCover {
 public:
  TriangleCover(Surface& surface, std::size_t most_cuts) : surface_(surface), cuts_(most_cuts) {}

  /// Whether the triangle is certified. Corners without a face get one.
  bool covers(CoverTriangle corners) {
    for (CoverCorner& corner : corners) {
      if (corner.face == no_index) corner.face = surface_.nearest(corner.point, corners[0].face);
      if (corner.face == no_index) return false;
    }
    return covers(corners, most_levels);
  }
  std::size_t cuts_left() const { return cuts_; }

 private:
  /// Triangles are cut again up to this often. Rounding of a cut moves a point by no more than two
  /// spacings, and all cuts together by 32: `rounding_share` in error_bound.cpp counts on that.
  /// Twice as many levels find no more certificates on folded and noisy shapes.
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
    double share = 0.5;  ///< part of the edge before the cut
  };

  /// On the longest edge of which neither end is near the face of the other end; if there is none,
  /// in the middle of the longest edge.
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

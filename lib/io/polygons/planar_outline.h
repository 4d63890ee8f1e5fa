/// Triangulates closed outlines in the plane without new points, by exact predicates. Computes the
/// constrained Delaunay triangulation of the edges and keeps the triangles with a winding number
/// other than 0. An outline may visit a point several times. For example, an edge that is traversed
/// in both directions may connect the outer boundary with a hole; the hole then stays open. Cost:
/// O(n log n) on usual outlines; deterministic.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace transformesh {

/// Three corners of a polygon, by index.
using CornerTriangle = std::array<std::uint32_t, 3>;

struct PlanarTriangles {
  /// The triangles. Their oriented boundary is the outline. Empty unless `is_complete`. A triangle
  /// with winding number w occurs |w| times, clockwise if w is negative.
  std::vector<CornerTriangle> triangles;
  /// Triangles without area. They occur if an edge passes through another corner of the outline.
  std::vector<CornerTriangle> flat;
  /// Number of `triangles` that have the less frequent orientation or repeat an earlier triangle.
  std::size_t folds = 0;
  /// Corners whose outline edge to the next corner has length 0 or intersects the outline edge of
  /// an earlier corner.
  std::vector<std::uint32_t> crossing;
  /// False if edges intersect, if all points are collinear, or if there would be more triangles
  /// than twice the corners of the outline.
  bool is_complete = false;
};

/// Triangulates one outline. `outline` lists the indices of its corners in order. `points` may
/// contain other points, too.
PlanarTriangles triangulate_outline(std::span<const Eigen::Vector2d> points,
                                    std::span<const std::uint32_t> outline);

/// Triangulates several outlines that do not intersect each other, such as an outer boundary and
/// its holes, which are clockwise. An outline of two corners is an edge constraint, and an outline
/// of one corner is a point.
PlanarTriangles triangulate_outlines(std::span<const Eigen::Vector2d> points,
                                     const std::vector<std::vector<std::uint32_t>>& outlines);

}  // namespace transformesh

/// Triangulates closed outlines in the plane without new points, by exact predicates: a constrained
/// Delaunay triangulation of their edges, of which the triangles with a winding number other than 0
/// are kept. An outline may visit a point again: a bridge that runs to a hole and back leaves the
/// hole open. Cost: O(n log n) for outlines that occur; deterministic.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace transformesh {

/// Three corners of a polygon, by their numbers.
using CornerTriangle = std::array<std::uint32_t, 3>;

struct PlanarTriangles {
  /// Together they have the oriented boundary of the outline; empty unless `is_complete`. A
  /// triangle with winding number w comes |w| times, clockwise if w is negative.
  std::vector<CornerTriangle> triangles;
  /// Triangles without area, where an edge runs through another corner of the outline.
  std::vector<CornerTriangle> flat;
  /// Number of `triangles` that have the rarer orientation or copy an earlier one.
  std::size_t folds = 0;
  /// Corners whose edge to the next corner has no length or crosses the edge of an earlier corner.
  std::vector<std::uint32_t> crossing;
  /// False if edges cross, if all points are collinear, or if there would be more triangles than
  /// twice the corners of the outline.
  bool is_complete = false;
};

/// `points` are all corners of a polygon, `outline` those that are still part of it, in order.
PlanarTriangles triangulate_outline(std::span<const Eigen::Vector2d> points,
                                    std::span<const std::uint32_t> outline);

/// The same for several outlines that do not cross, such as those of a part and of its holes, which
/// are clockwise then. Two corners are an edge that the triangles have, one is a point.
PlanarTriangles triangulate_outlines(std::span<const Eigen::Vector2d> points,
                                     const std::vector<std::vector<std::uint32_t>>& outlines);

}  // namespace transformesh

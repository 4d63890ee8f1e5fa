/// Triangulates a polygon in space without new vertices. The polygon is projected along the
/// coordinate axis nearest to its normal (Newell), so that the coordinates stay the doubles that
/// they are and all predicates are exact; the normal itself and the other axes are tried if the
/// projection intersects itself. Guarantees:
/// - Together the triangles have the oriented boundary of the polygon.
/// - A polygon whose first projection meets itself in points and along bridges only is triangulated
///   without overlaps, by triangles of one orientation and of positive area, unless an edge of it
///   runs through another corner.
/// - The fan from the first corner is kept if it has no fold there and no triangle without area.
/// - Any other polygon is triangulated in the projection with the fewest folds and upright
/// triangles. Cost: O(n log n) for polygons that occur. Deterministic.
#pragma once

#include <span>

#include "io/polygons/planar_outline.h"
#include "mesh/mesh.h"

namespace transformesh {

struct PolygonTriangles {
  std::vector<CornerTriangle> triangles;  ///< numbers of corners; no triangle names a vertex twice
  /// Triangles that overlap others in the best projection. 0 for every polygon that has a
  /// projection along an axis or its normal without overlaps.
  std::size_t folds = 0;
  /// Triangles without area in that projection, but with one in space.
  std::size_t upright = 0;
};

/// Whether the fan from the first corner is kept, so that its triangles are (0, i - 1, i).
bool is_unfolded_fan(std::span<const Vec3> positions);

/// `positions` are those of the corners, `vertices` their indices; all coordinates are finite. A
/// corner whose neighbors are the same vertex is a spike, bounds nothing and is left out.
PolygonTriangles triangulate_polygon(std::span<const Vec3> positions,
                                     std::span<const Index> vertices);

}  // namespace transformesh

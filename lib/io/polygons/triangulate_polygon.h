/// Triangulates a polygon in space without new vertices. The polygon is projected along the
/// coordinate axis nearest to its normal (Newell). The projected coordinates are then the original
/// doubles, and all predicates are exact. If this projection intersects itself, the normal and the
/// other axes are tried.
///
/// Guarantees:
/// - Together the triangles have the oriented boundary of the polygon.
/// - Suppose that the first projection touches itself only in points and along bridges, and no edge
///   passes through another corner. Then the triangles do not overlap and have positive area and
///   equal orientation.
/// - The triangle fan from the first corner is used if it has no fold in the first projection and
///   no triangle without area.
/// - Any other polygon is triangulated in the projection with the fewest overlapping triangles and
///   triangles whose projection has no area.
///
/// Cost: O(n log n) on usual polygons. Deterministic.
#pragma once

#include <span>

#include "io/polygons/planar_outline.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct PolygonTriangles {
  std::vector<CornerTriangle> triangles;  ///< indices of corners; no triangle has a vertex twice
  /// Number of triangles that overlap others in the best projection. It is 0 if the projection of
  /// the polygon along an axis or its normal has no overlaps.
  std::size_t folds = 0;
  /// Number of triangles with an area in space, but not in the best projection.
  std::size_t upright = 0;
};

/// True if triangulate_polygon() uses the fan from the first corner, with the triangles (0, i - 1,
/// i).
bool is_unfolded_fan(std::span<const Vec3> positions);

/// Triangulates a polygon. `positions` are the positions of the corners, `vertices` their indices;
/// all coordinates are finite. A corner whose two neighbors are the same vertex is a spike and is
/// left out.
PolygonTriangles triangulate_polygon(std::span<const Vec3> positions,
                                     std::span<const Index> vertices);

}  // namespace transformesh

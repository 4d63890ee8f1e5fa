/// Triangulations of a closed polygon in space, the border of a hole, without additional vertices.
/// They contain no triangles without area, and no inner edges that the surrounding mesh already
/// has. Deterministic.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

struct HoleBorder {
  std::vector<Vec3> points;  ///< border points in order around the hole
  /// Position of the third corner of the face of the surrounding mesh at the edge from each point
  /// to the next.
  std::vector<Vec3> across;
  /// Edges of the surrounding mesh between border points that are not neighbors on the border.
  /// Sorted pairs of indices of points, with the smaller index first.
  std::vector<std::pair<Index, Index>> chords;
};

/// Corners i < m < k of a triangle, as indices in HoleBorder::points. In a list of triangles, the
/// neighbors of a triangle at its edges (i, m) and (m, k) precede it.
using HoleTriangle = std::array<Index, 3>;

/// Returns the best triangulation as defined by Liepa, "Filling holes in meshes", SGP 2003, and
/// CGAL. Its largest angle between normals of neighboring triangles is least, and its area is the
/// least of such triangulations. Empty if there is no triangulation. Cost: O(n^3) comparisons,
/// usually O(n^2) angles: 1,000 points take 0.1 s.
std::vector<HoleTriangle> least_triangulation(const HoleBorder& border);

/// Returns the best triangulation of which each edge is between near points, or is an edge of
/// greedy_triangulation(). The result is therefore at least as good as greedy_triangulation().
/// Cost: O(n log n).
std::vector<HoleTriangle> sparse_triangulation(const HoleBorder& border);

/// Returns the best triangulation of which each edge is in `edges` (pairs of indices of points), or
/// is an edge of greedy_triangulation(). Cost: O(n log n) if the number of edges per point is
/// bounded.
std::vector<HoleTriangle> triangulation_among(const HoleBorder& border,
                                              std::vector<std::pair<Index, Index>> edges);

/// Triangulates the polygon by cutting off corners. The next corner is always the one whose new
/// edge is shortest. Empty if no corner can be cut off. Cost: O(n log n).
std::vector<HoleTriangle> greedy_triangulation(const HoleBorder& border);

}  // namespace transformesh

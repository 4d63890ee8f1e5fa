/// Triangulations of a closed polygon in space, the border of a hole, without new vertices.
/// Degenerate triangles, and edges that the surrounding mesh already has, are not used.
/// Deterministic.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

struct HoleBorder {
  std::vector<Vec3> points;  ///< border points in order around the hole
  std::vector<Vec3> across;  ///< third corner of the face at the edge from each point to the next
  /// Edges of the mesh between points that are not neighbors on the border: sorted pairs with the
  /// smaller index first.
  std::vector<std::pair<Index, Index>> chords;
};

/// Corners i < m < k of a triangle, as indices of points. Triangles across the edges (i, m) and (m,
/// k) precede it in a triangulation.
using HoleTriangle = std::array<Index, 3>;

/// Returns the triangulation with the least maximal dihedral angle and then the least area, as in
/// Liepa, "Filling holes in meshes", SGP 2003, and CGAL. Empty if there is no triangulation. Cost:
/// O(n^3) comparisons, usually O(n^2) angles: 1,000 points take 0.1 s.
std::vector<HoleTriangle> least_triangulation(const HoleBorder& border);

/// Returns the best triangulation whose edges are between near points or belong to
/// greedy_triangulation(). The result is therefore at least as good as greedy_triangulation().
/// Cost: O(n log n).
std::vector<HoleTriangle> sparse_triangulation(const HoleBorder& border);

/// Returns the best triangulation whose edges are in `edges` (pairs of indices of points) or belong
/// to greedy_triangulation(). Cost: O(n log n) for edges of bounded valence.
std::vector<HoleTriangle> triangulation_among(const HoleBorder& border,
                                              std::vector<std::pair<Index, Index>> edges);

/// Triangulates by cutting off corners, always the corner with the shortest new edge. Empty if no
/// corner can be cut off. Cost: O(n log n).
std::vector<HoleTriangle> greedy_triangulation(const HoleBorder& border);

}  // namespace transformesh

/// Triangulations of a closed polygon in space, the border of a hole, without new vertices.
/// Triangles that are collinear, and edges that the mesh around the hole has already, are not used.
/// Deterministic.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

struct HoleBorder {
  std::vector<Vec3> points;  ///< In order around the hole.
  std::vector<Vec3> across;  ///< Per point, the third corner of the face at the edge to the next.
  /// Edges of the mesh between points that are not neighbors, the smaller number first. Sorted.
  std::vector<std::pair<Index, Index>> chords;
};

/// Corners i < m < k of a triangle, as numbers of points. Triangles that lie beyond the edges (i,
/// m) and (m, k), in this order, come before.
using HoleTriangle = std::array<Index, 3>;

/// The triangulation with the smallest largest dihedral angle and then the smallest area, as Liepa,
/// "Filling holes in meshes", SGP 2003, and CGAL have it. Empty if there is none.
/// Cost: O(n^3) comparisons, and O(n^2) angles as a rule: 1,000 points take a tenth of a second.
std::vector<HoleTriangle> least_triangulation(const HoleBorder& border);

/// The same among the edges to the nearest points and those of greedy_triangulation(), so that it
/// is at least as good as that. Cost: O(n log n).
std::vector<HoleTriangle> sparse_triangulation(const HoleBorder& border);

/// The same among edges that are given, as pairs of numbers of points, and those of
/// greedy_triangulation(). Cost: O(n log n) for edges of bounded valence.
std::vector<HoleTriangle> triangulation_among(const HoleBorder& border,
                                              std::vector<std::pair<Index, Index>> edges);

/// Cuts off one corner after the other, first where the new edge is shortest. Empty if no corner is
/// left that may be cut off. Cost: O(n log n).
std::vector<HoleTriangle> greedy_triangulation(const HoleBorder& border);

}  // namespace transformesh

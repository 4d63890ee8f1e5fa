/// Umbrellas of a mesh: maximal sets of faces at a vertex that are connected across edges. A vertex
/// of a manifold has one umbrella; a singular vertex has several. Cost: O(n); deterministic.
#pragma once

#include <span>
#include <vector>

#include "mesh/edges.h"
#include "support/raw_vector.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct Umbrellas {
  /// Umbrella of each corner 3 * face + i; no_index if its face is left out.
  RawVector<Index> of_corner;
  RawVector<Index> vertex_of;     ///< vertex of each umbrella, in order of their first corners
  RawVector<Index> first_corner;  ///< smallest corner of each umbrella
};

/// Finds the umbrellas. `across` holds for each halfedge the halfedge with which the surface
/// continues across the edge, or no_index. Both may have opposite or equal directions. Faces with
/// included[face] = 0 are left out; an empty list includes all.
Umbrellas find_umbrellas(std::span<const Face> faces, std::span<const Index> across,
                         std::span<const char> included = {});

/// Does the same as find_umbrellas(), faster. Halfedges across an edge must have opposite
/// directions.
Umbrellas find_oriented_umbrellas(std::span<const Face> faces, std::span<const Index> across,
                                  std::span<const char> included = {});

/// Finds the umbrellas of a mesh whose surface continues across edges with exactly two faces, of
/// any orientation.
Umbrellas find_umbrellas(const Mesh& mesh, const Edges& edges);

/// Returns the lowest border halfedge (on an edge of one face) of each boundary loop. If several
/// umbrellas meet at a vertex, each loop passes the vertex within one umbrella.
std::vector<Index> boundary_loops(const Edges& edges, const Umbrellas& umbrellas);

}  // namespace transformesh

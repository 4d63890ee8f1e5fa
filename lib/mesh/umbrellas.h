/// The umbrellas of a mesh (paper 3.3): sets of faces around a vertex that are connected across
/// edges. A vertex of a manifold has one, a singular vertex several. Cost: O(n); deterministic.
#pragma once

#include <span>
#include <vector>

#include "mesh/edges.h"
#include "mesh/mesh.h"

namespace transformesh {

struct Umbrellas {
  std::vector<Index> of_corner;  ///< per corner 3 * face + i; no_index where its face is left out
  std::vector<Index> vertex_of;  ///< per umbrella, in the order of their first corners
};

/// `across`: where the surface goes on beyond each halfedge, or no_index; the two may have opposite
/// directions or the same one. Faces without included[face] are left out; an empty list includes
/// all.
Umbrellas find_umbrellas(std::span<const Face> faces, std::span<const Index> across,
                         std::span<const char> included = {});

/// The umbrellas of a mesh whose surface goes on across edges with exactly two faces, of any
/// orientation.
Umbrellas find_umbrellas(const Mesh& mesh, const Edges& edges);

/// The lowest border halfedge (one on an edge with a single face) of each boundary loop. Where
/// several umbrellas meet at a vertex, loops follow the umbrella.
std::vector<Index> boundary_loops(const Edges& edges, const Umbrellas& umbrellas);

}  // namespace transformesh

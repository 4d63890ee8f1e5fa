/// Which halfedges of a list of triangles lie across from each other.
#pragma once

#include <span>
#include <vector>

#include "tm/mesh/mesh.h"

namespace transformesh {

/// For each halfedge the one that runs back along its edge, or no_index on a border, given where
/// the halfedges start (three for each face) and the number of vertices. Throws InputError with
/// face ids where an index is out of range, a face uses a vertex twice, or two faces run the same
/// way along an edge, as where there are three. O(n).
std::vector<Index> opposites_of(std::span<const Index> sources, std::size_t vertices);

}  // namespace transformesh

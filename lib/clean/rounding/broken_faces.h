/// Finds and removes faces that rounding of exact points to stored coordinates broke (paper 4.3).
#pragma once

#include <vector>

#include "clean/stitch/assemble.h"

namespace transformesh {

/// Broken faces at the present coordinates.
struct BrokenFaces {
  std::vector<Index> faces;  ///< faces that intersect a new face, or have no area; ascending
  std::size_t pairs = 0;     ///< number of intersecting pairs with at least one new face
};

/// Finds the broken faces. Whole input faces must not intersect each other. Cost: O(n log n).
BrokenFaces find_broken_faces(const Assembly& assembly);

/// Returns `faces` and all faces that share a corner with them, in ascending order.
std::vector<Index> with_faces_around(const Mesh& mesh, const std::vector<Index>& faces);

/// Returns the number of connected sets of `faces`. Faces that share a corner are connected.
std::size_t count_places(const Mesh& mesh, const std::vector<Index>& faces);

/// Merges the indices of vertices with equal positions. Drops faces that refer to a vertex twice,
/// and pairs of coincident new faces with opposite orientation. A closed mesh stays closed. Returns
/// true if a face was dropped.
bool drop_collapsed_faces(Assembly& assembly);

}  // namespace transformesh

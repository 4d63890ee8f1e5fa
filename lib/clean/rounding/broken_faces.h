/// What rounding of exact points to stored coordinates breaks (paper 4.3). Cost: O(n log n).
#pragma once

#include <vector>

#include "clean/stitch/assemble.h"

namespace transformesh {

/// In the coordinates as they are.
struct BrokenFaces {
  std::vector<Index> faces;  ///< that intersect a new face, or have no area; ascending
  std::size_t pairs = 0;     ///< that intersect, one of them being new
};

/// Whole input faces are known not to intersect each other.
BrokenFaces find_broken_faces(const Assembly& assembly);

/// The faces, and all others that have a corner in common with them; ascending.
std::vector<Index> with_faces_around(const Mesh& mesh, const std::vector<Index>& faces);

/// In how many places faces lie: those that share corners lie in one.
std::size_t count_places(const Mesh& mesh, const std::vector<Index>& faces);

/// Gives all vertices at one position one index, and drops faces that name a vertex twice, and
/// pairs of new faces that lie upon each other with opposite sense. What is closed stays closed.
/// Returns whether a face was dropped.
bool drop_collapsed_faces(Assembly& assembly);

}  // namespace transformesh

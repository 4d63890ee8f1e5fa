/// What rounding of exact points to stored coordinates breaks (paper 4.3). Cost: O(n log n).
#pragma once

#include <utility>
#include <vector>

#include "tm/clean/stitch/assemble.h"

namespace transformesh {

/// Faces that intersect a new face, or have no area, in the coordinates as they are; ascending.
/// Whole input faces are known not to intersect each other.
std::vector<Index> find_broken_faces(const Assembly& assembly);

/// The pairs of faces of which one is new that intersect, sorted.
std::vector<std::pair<Index, Index>> find_crossings(const Assembly& assembly);

/// The faces that are no whole faces of the input; ascending.
std::vector<Index> find_new_faces(const Assembly& assembly);

/// The faces, and all others that have a corner in common with them; ascending.
std::vector<Index> with_faces_around(const Mesh& mesh, const std::vector<Index>& faces);

/// In how many places faces lie: those that share corners lie in one.
std::size_t count_places(const Mesh& mesh, const std::vector<Index>& faces);

/// Gives all vertices at one position one index, and drops faces that name a vertex twice, and
/// pairs of new faces that lie upon each other with opposite sense. What is closed stays closed.
/// Returns whether a face was dropped.
bool drop_collapsed_faces(Assembly& assembly);

}  // namespace transformesh

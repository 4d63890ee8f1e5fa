/// What rounding of exact points to stored coordinates breaks, and how it is mended: faces that
/// cross or vanish as rounded are snapped to a grid, coarser in every round, and cleaned again.
#pragma once

#include <vector>

#include "tm/clean/assemble.h"

namespace transformesh {

/// Faces that take part in a crossing with a new face, or have no area, in the coordinates as they
/// are. Whole input faces do not cross each other.
std::vector<Index> find_broken_faces(const Assembly& assembly);

/// Rounds the corners of the faces given to multiples of the spacing of floats (or doubles) at the
/// mesh's largest coordinate times 2^doublings. Input vertices move only where `move_old`.
void snap(Assembly& assembly, const std::vector<Index>& faces, Scalar coordinate, int doublings,
          bool move_old);

}  // namespace transformesh

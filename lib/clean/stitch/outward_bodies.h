/// Bodies that are inside out. A body is a closed component that no other one contains, together
/// with all components in it: cavities, and bodies inside of cavities. A body is inside out if the
/// volume of its outer component is negative. Containment is decided by exact winding numbers at
/// vertices. Cost: O(n log n) for components whose boxes are nested in few others. Deterministic.
#pragma once

#include <cstddef>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns whether a body is inside out.
bool has_inward_bodies(const Mesh& mesh);

/// Reverses the faces of bodies that are inside out, cavities included, so that cavities stay
/// cavities. Returns the number of faces reversed.
std::size_t turn_bodies_outwards(Mesh& mesh);

/// Reverses closed components until those in an even number of others look outwards, and those in
/// an odd number inwards, as cavities. Returns the number of faces reversed.
std::size_t turn_nested_alternately(Mesh& mesh);

}  // namespace transformesh

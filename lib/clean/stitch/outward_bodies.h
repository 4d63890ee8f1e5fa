/// Finds and reverses bodies that are inside out. A body is a closed component that no other
/// component contains, together with all components in it: cavities, and bodies inside cavities. A
/// body is inside out if the volume of its outer component is negative. Exact winding numbers at
/// vertices decide on containment. Cost: O(n log n) if few boxes of components are nested.
/// Deterministic.
#pragma once

#include <cstddef>

#include "transformesh/mesh.h"

namespace transformesh {

bool has_inward_bodies(const Mesh& mesh);

/// Reverses all components of bodies that are inside out, so that cavities remain cavities. Returns
/// the number of reversed faces.
std::size_t turn_bodies_outwards(Mesh& mesh);

/// Orients closed components by their nesting depth: outwards at even depth, and inwards, like
/// cavities, at odd depth. Returns the number of reversed faces.
std::size_t turn_nested_alternately(Mesh& mesh);

}  // namespace transformesh

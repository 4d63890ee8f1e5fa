/// Finds and reverses bodies that are inside out. A body is a closed component that no other
/// component contains, together with all components in it: cavities, and bodies inside cavities. A
/// body is inside out if the volume of its outer component is negative. Exact winding numbers at
/// vertices decide whether a closed component contains another component. For components with
/// borders, generalized winding numbers decide. Cost: O(n log n) if few boxes of components are
/// nested. Deterministic.
#pragma once

#include <cstddef>

#include "transformesh/mesh.h"

namespace transformesh {

bool has_inward_bodies(const Mesh& mesh);

/// True if a closed component lies inside others such that the winding number on one of its sides
/// is neither 0 nor 1. An example is a body inside a body. Components must not intersect.
bool has_bodies_in_bodies(const Mesh& mesh);

/// Reverses all components of each body that is inside out, so that cavities remain cavities. A
/// body is an outermost closed component with all components in it. Returns the number of reversed
/// faces.
std::size_t turn_bodies_outwards(Mesh& mesh);

/// Orients each closed component by the number of closed components that contain it: outwards if
/// the number is even, and inwards, like a cavity, if it is odd. Returns the number of reversed
/// faces.
std::size_t turn_nested_alternately(Mesh& mesh);

}  // namespace transformesh

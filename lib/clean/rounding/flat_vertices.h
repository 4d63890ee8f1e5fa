/// Removes vertices around which the surface is flat (paper 4.3), and short edges. Each cut of
/// nearly coplanar faces leaves slivers in one plane. Rounding reverses these slivers, and the next
/// cut makes them even smaller. Therefore an edge at a flat vertex is collapsed to its other end.
/// The collapse must fulfill three conditions. The surface moves by at most the tolerance. No
/// normal turns by more than 60 degrees. The lowest triangle around the vertex, relative to its
/// longest edge, does not become lower. Such collapses remove cuts that only rounding caused. An
/// edge shorter than half the tolerance is collapsed regardless of these conditions.
///
/// A closed mesh stays closed: only simple umbrellas change, and only if the link condition holds
/// (Hoppe, DeRose, Duchamp, McDonald & Stuetzle, "Mesh optimization", SIGGRAPH 1993).
/// Deterministic. Cost: O(k d^2) for k vertices of valence d.
#pragma once

#include <vector>

#include "clean/rounding/vertex_grids.h"

namespace transformesh {

/// Removes vertices of `faces`: new vertices, and vertices of the input if `moves_input` is set.
/// Equal positions must have equal indices. The surface moves by at most `steps` grid steps at the
/// removed vertex. Collapsed faces refer to a vertex twice. Returns true if a vertex was removed;
/// adds the displacement to `moved`. If a flat vertex is removed, the faces around it stay within
/// the input faces that they are cut from. The collapse of a short edge moves them by at most its
/// length.
bool remove_flat_vertices(const Mesh& input, Assembly& assembly, const std::vector<Index>& faces,
                          double steps, bool moves_input, const VertexGrids& grids,
                          Displacement& moved);

}  // namespace transformesh

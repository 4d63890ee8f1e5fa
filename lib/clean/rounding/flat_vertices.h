/// Removes vertices around which the surface is flat (paper 4.3), and short edges. Cutting nearly
/// coplanar faces creates nearly coplanar slivers. Rounding reverses these slivers, and the next
/// cut makes them even smaller. Therefore an edge at a flat vertex is collapsed to its other end.
/// The collapse must fulfill three conditions. The surface moves by at most the tolerance. No
/// normal turns by more than 60 degrees. The least ratio of height to longest edge of the triangles
/// around the vertex does not decrease. Collapses of this kind remove cuts that only rounding
/// caused. An edge shorter than half the tolerance is collapsed regardless of these conditions.
///
/// A closed mesh stays closed, because a vertex is removed only under two conditions. Its faces
/// must form one closed umbrella, and the link condition must hold (Hoppe, DeRose, Duchamp,
/// McDonald & Stuetzle, "Mesh optimization", SIGGRAPH 1993). Deterministic. Cost: O(k d^2) for k
/// vertices of valence d.
#pragma once

#include <vector>

#include "clean/rounding/vertex_grids.h"

namespace transformesh {

/// Removes vertices of `faces` that are new, and vertices of the input if `moves_input` is set.
/// Equal positions must have equal indices. The surface moves by at most `steps` grid steps
/// (vertex_grids.h) at the removed vertex. Faces that vanish stay in the list, but refer to a
/// vertex twice. Returns true if a vertex was removed; adds the displacement to `moved`. If a flat
/// vertex is removed, each face around the vertex stays within the tolerance of the input face that
/// it is cut from. The collapse of a short edge moves faces by at most its length.
bool remove_flat_vertices(const Mesh& input, Assembly& assembly, const std::vector<Index>& faces,
                          double steps, bool moves_input, const VertexGrids& grids,
                          Displacement& moved);

}  // namespace transformesh

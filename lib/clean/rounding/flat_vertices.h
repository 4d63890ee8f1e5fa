/// Removes vertices around which the surface is flat (paper 4.3), and edges that are short. Every
/// cut of nearly coplanar faces leaves slivers on one plane, which rounding turns over, and which
/// the next cut makes smaller still. An edge at such a vertex is collapsed to its other end. For
/// that the surface may move by no more than the tolerance, and no normal may turn by more than 60
/// degrees. The lowest triangle around, relative to its longest edge, may not become lower. So cuts
/// that only rounding made go again. An edge shorter than half of the tolerance is collapsed
/// whatever it turns. What is closed stays closed: only simple umbrellas change, and only if the
/// link condition holds. Reference: Hoppe, DeRose, Duchamp, McDonald & Stuetzle, "Mesh
/// optimization", SIGGRAPH 1993, for the link condition. Deterministic. Cost: O(k d^2) for k
/// vertices of valence d.
#pragma once

#include <vector>

#include "clean/rounding/vertex_grids.h"

namespace transformesh {

/// Equal positions have equal indices. Vertices of the faces go; those of the input only if they
/// may. The surface moves by at most `steps` steps of the vertex that goes. Vanished faces name a
/// vertex twice. Returns whether a vertex went, and notes how far.
/// Where a flat vertex goes, the faces around it stay within that of the faces of the input from
/// which they are cut. The collapse of a short edge moves them by no more than its length.
bool remove_flat_vertices(const Mesh& input, Assembly& assembly, const std::vector<Index>& faces,
                          double steps, bool moves_input, const VertexGrids& grids,
                          Displacement& moved);

}  // namespace transformesh

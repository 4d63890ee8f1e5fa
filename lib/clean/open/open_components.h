/// The closed part of a mesh and its open components (beyond paper 4.6;
/// docs/design/open-meshes.md). The faces of the closed part traverse every edge equally often in
/// both directions, so they have integer winding numbers. An open component is a connected set of
/// the other faces.
///
/// Faces are connected across edges of two faces with opposite directions. At an edge of more
/// faces, two faces are connected if no third one names the same two vertices. A connected set that
/// leaves no halfedge over is closed. Others become open until the sum of directions
/// along every edge of the rest is zero. First those go that have
/// an edge which the rest traverses in one direction only. If edges with a surplus are left, sheets
/// that are enclosed by bodies go (enclosed_sheets.h), then all sets that are part of such a
/// surplus. So a wall within a body, given once, is open, and the skin around it is closed. The
/// result does not depend on the order of the faces. Cost: O(n log n); with a surplus that of
/// enclosed_sheets.h.
#pragma once

#include <functional>
#include <vector>

#include "clean/intersect/welded_mesh.h"

namespace transformesh {

/// Finds the sheets that a surplus makes doubtful: marks per welded face (enclosed_sheets.h).
using FindEnclosed = std::function<std::vector<char>()>;

/// Per welded face the number of its open component, or no_index in the closed part. Components are
/// numbered in the order of their first faces. Faces without area count for edges, but have no
/// entry. A stitched mesh (borders.h) is taken as its indices say, any other as its positions do.
/// So of what cleaning has made, parts that merely touch do not enclose each other.
std::vector<Index> find_open_components(const Mesh& mesh, const WeldedMesh& welded,
                                        bool is_stitched, const FindEnclosed& find_enclosed);

}  // namespace transformesh

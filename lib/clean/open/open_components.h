/// Divides a mesh into its closed part and open components (beyond paper 4.6;
/// docs/design/open-meshes.md). The faces of the closed part traverse each edge equally often in
/// both directions, so they define integer winding numbers. An open component is a connected set of
/// other faces.
///
/// Faces are connected across edges of two faces with opposite directions. At an edge of more
/// faces, two faces are connected if no third face refers to the same two vertices. A connected set
/// without unpaired halfedges is closed. Other sets become open until the sum of directions along
/// each edge of the remaining faces is zero, in this order:
///
/// 1. Sets with an edge that the remaining faces traverse in one direction only.
/// 2. If edges with a nonzero sum (a surplus) remain: sheets that bodies enclose
/// (enclosed_sheets.h).
/// 3. All sets that belong to such a surplus.
///
/// Hence a single wall inside a body is open, and the surface around the wall is closed. The result
/// does not depend on the order of faces. Cost: O(n log n), plus that of enclosed_sheets.h if there
/// is a surplus.
#pragma once

#include <functional>
#include <vector>

#include "clean/intersect/welded_mesh.h"

namespace transformesh {

/// Returns a mark for each welded face: 1 if it belongs to an enclosed sheet (enclosed_sheets.h).
using FindEnclosed = std::function<std::vector<char>()>;

/// Returns for each welded face the number of its open component, or no_index in the closed part.
/// Components are numbered in the order of their first faces. Faces without area are considered at
/// edges, but have no entry. In a stitched mesh (borders.h) vertices define connectivity, in any
/// other mesh positions do. Hence parts of a cleaned mesh that only touch do not enclose each
/// other.
std::vector<Index> find_open_components(const Mesh& mesh, const WeldedMesh& welded,
                                        bool is_stitched, const FindEnclosed& find_enclosed);

}  // namespace transformesh

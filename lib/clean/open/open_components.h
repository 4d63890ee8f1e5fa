/// Divides a mesh into its closed part and open components (beyond paper 4.6;
/// docs/design/open-meshes.md). The faces of the closed part traverse each edge equally often in
/// both directions, so they define integer winding numbers. An open component is a connected set of
/// other faces.
///
/// Faces are connected across edges of two faces with opposite directions. At an edge of more than
/// two faces, two faces are connected if no third face refers to the same two vertices. A connected
/// set of faces is closed if each of its halfedges is paired in this way. Of the other sets, some
/// become open components, until the remaining faces traverse each edge equally often in both
/// directions. The order is:
///
/// 1. Sets with an edge that the remaining faces traverse in one direction only.
/// 2. If the remaining faces traverse edges unequally often in both directions: sheets that bodies
/// enclose (enclosed_sheets.h).
/// 3. All sets with a face that traverses such an edge in the more frequent direction.
///
/// Hence a single wall inside a body is open, and the surface around the wall is closed. The result
/// does not depend on the order of faces. Cost: O(n log n), plus that of enclosed_sheets.h if step
/// 2 is necessary.
#pragma once

#include <functional>
#include <vector>

#include "clean/intersect/welded_mesh.h"

namespace transformesh {

/// Function that returns for each welded face 1 if it belongs to an enclosed sheet
/// (enclosed_sheets.h), otherwise 0.
using FindEnclosed = std::function<std::vector<char>()>;

/// Returns for each welded face the number of its open component, or no_index in the closed part.
/// Components are numbered in the order of their first faces. Faces without area are considered at
/// edges, but have no entry in the result. If `is_stitched` is true (borders.h), vertex indices
/// define which faces are neighbors, otherwise positions do. Hence parts of a cleaned mesh that
/// merely touch are separate components.
std::vector<Index> find_open_components(const Mesh& mesh, const WeldedMesh& welded,
                                        bool is_stitched, const FindEnclosed& find_enclosed);

}  // namespace transformesh

/// Normals of faces that are reliable for slivers too, and a test whether a mesh has intended sharp
/// edges. The turn of an edge is the angle between the normals of its faces.
#pragma once

#include <vector>

#include "remesh/halfedges/editable_mesh.h"

namespace transformesh {

/// Returns the unit normal of every face slot. If the height of a face is below 16 spacings of the
/// coordinates, its own normal is noise. Such a face takes the normal of the face across its
/// longest edge, which may take it from the next face. If this finds no normal, the nearest face
/// across any edges gives its normal. The result is zero if there is no normal, and in dead slots.
/// O(n).
std::vector<Vec3> steady_normals(const EditableMesh& mesh);

/// True if a mesh certainly has intended sharp edges, which do not come from noise or coarse
/// meshing.
///
/// An edge is sharp if it turns by more than 60 degrees. A sharp edge is intended if the surface
/// beside it is smooth. This means that all other edges at its ends, except edges that turn by more
/// than 40 degrees, turn by less than 0.45 times as much. There are three conditions:
/// - Intended edges have at least 0.9 of the length of sharp edges.
/// - Intended edges have at least 0.25 of the length of all edges that turn by more than 40
/// degrees.
/// - The length of intended edges is at least half the square root of the area. A cube has 4.9, a
/// cone
///   2, two balls that meet in a circle 0.8. This condition excludes tips and rims that remain
///   where a neck broke.
///
/// The first two ratios do not depend on the resolution. In 80 meshes of public collections,
/// mechanical parts have at least 0.98 and 0.28. Scans and figures have at most 0.88 or 0.03, with
/// one exception, a hare of 1,252 faces. O(n).
bool has_sharp_edges(const EditableMesh& mesh);

}  // namespace transformesh

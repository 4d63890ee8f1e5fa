/// How much edges turn, also beside faces too thin to have a direction of their own, and whether a
/// mesh has sharp edges that are meant.
#pragma once

#include <vector>

#include "remesh/halfedges/editable_mesh.h"

namespace transformesh {

/// The unit normal of every face slot. The normal of a face whose height is below 16 spacings of
/// the coordinates is noise: it takes that of the face across its longest edge, or where that leads
/// nowhere, across any edge. Zero where there is none, and in dead slots. O(n).
std::vector<Vec3> steady_normals(const EditableMesh& mesh);

/// Whether there are sharp edges for certain, and not by noise or coarseness. Edges that turn by
/// more than 60 degrees are sharp; they are meant where the surface beside them is smooth: no other
/// edge at their ends turns by 0.35 times as much, except those by more than 40 degrees. Nine
/// tenths of the length of sharp edges must be meant, and a quarter of that of all edges by more
/// than 40 degrees, neither of which depends on how fine the mesh is; and they are at least half as
/// long as the root of the area, so that the tips and rims that an evolution leaves where a neck
/// breaks do not count: a cube has 4.9, a cone 2, two balls that meet in a circle 0.8.
/// (Of 80 meshes in public collections, mechanical parts have at least 0.98 and 0.28, scans and
/// figures at most 0.79 or 0.03, for one exception, a hare of 1,252 faces.) O(n).
bool has_sharp_edges(const EditableMesh& mesh);

}  // namespace transformesh

/// Reverses faces such that neighbors have consistent orientation.
///
/// A sheet is a set of faces that are connected across edges of two faces. If copies of a sheet
/// coincide, each copy is a sheet (coincident_sheets.h). Within a sheet, faces are reversed until
/// they traverse common edges in opposite directions.
///
/// Sheets that end at edges of more than two faces are reversed as a whole. The aim is that equally
/// many faces, except at most one, traverse such an edge in each direction. Solids that share edges
/// or faces then have consistent insides. If several choices are equally good, the larger volume
/// decides.
///
/// A group is a set of sheets that are linked by such edges. A group that was consistently oriented
/// is not changed, even if it is inside out, unless a copy of one of its sheets was inconsistent.
/// Any other group is oriented outwards if it has no border, otherwise like the majority of its
/// faces.
///
/// Faces that refer to a vertex twice are ignored and not changed. Volumes are computed in doubles.
/// Cost: O(n log n). Deterministic. The method is a greedy heuristic without a reference.
#pragma once

#include <cstddef>

#include "transformesh/mesh.h"

namespace transformesh {

/// Orients the faces of a mesh; returns the number of reversed faces. Vertices are equal if their
/// indices are. Columns and the order of faces do not change. If `keeps_most` is set, closed groups
/// are oriented like the majority of their faces instead of outwards. Throws InputError that names
/// the place if a sheet is one-sided; then the mesh is unchanged.
std::size_t orient_faces(Mesh& mesh, bool keeps_most = false);

/// True if orient_faces() leaves no misoriented edge (orientation_check.h).
bool can_be_oriented(Mesh mesh);

}  // namespace transformesh

/// Reverses faces such that neighbors have consistent orientation.
///
/// A sheet is a set of faces that are connected across edges of two faces. If copies of a sheet
/// coincide, each copy is a sheet (coincident_sheets.h). Within a sheet, faces are reversed until
/// they traverse common edges in opposite directions.
///
/// Sheets that end at edges of more than two faces are reversed as a whole. The aim is that the
/// numbers of faces that traverse such an edge in each direction differ by at most one. Solids that
/// share edges or faces then have consistent insides. If several choices are equally good, the
/// larger volume decides.
///
/// A group is a set of sheets that are linked by such edges. A group that is consistently oriented
/// in the input is not changed, even if it is inside out. Exception: a sheet that coincides with
/// one of its sheets is not consistently oriented. If a group is changed and has no border, it is
/// oriented outwards. If it has a border, most of its faces keep their orientation.
///
/// Faces that refer to a vertex twice are ignored and not changed. Volumes are computed in doubles.
/// Cost: O(n log n). Deterministic. The method is a greedy heuristic without a reference.
#pragma once

#include <cstddef>

#include "transformesh/mesh.h"

namespace transformesh {

/// Orients the faces of a mesh; returns the number of reversed faces. Vertices are equal if their
/// indices are. Columns and the order of faces do not change. If `keeps_most` is set, changed
/// groups without border are not oriented outwards: most of their faces keep their orientation
/// instead. Throws InputError if a sheet is one-sided; the error names an edge. Then the mesh is
/// unchanged.
std::size_t orient_faces(Mesh& mesh, bool keeps_most = false);

/// True if the mesh has no misoriented edge (orientation_check.h) after orient_faces().
bool can_be_oriented(Mesh mesh);

}  // namespace transformesh

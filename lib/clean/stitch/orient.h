/// Reverses faces so that neighbors agree which side is outside.
///
/// Faces that hang together across edges of two faces are a sheet, and so are those of each copy of
/// it where copies lie upon each other (coincident_sheets.h); they are reversed until they traverse
/// those edges in opposite directions. Sheets that end at edges of more faces are reversed as a
/// whole, until as many faces have one direction along such an edge as the other, or one more, as
/// far as possible: solids that share edges or faces get their insides back. Where that leaves a
/// choice, the larger volume decides. Sheets that are linked by such edges are a group. If a group
/// did not agree before, it then looks outwards where none of its edges has one face only, and the
/// way most of its faces did otherwise. A group that agreed is left alone, inside out or not,
/// unless a copy of it did not.
///
/// Faces that name a vertex twice have no say, and are left alone.
/// Volumes are in doubles. Cost: O(n log n). Deterministic.
#pragma once

#include <cstddef>

#include "transformesh/mesh.h"

namespace transformesh {

/// Vertices are the same when their indices are. Columns and the order of faces stay as they are.
/// Returns the number of faces reversed. Throws InputError, naming the place, where a sheet has one
/// side only; then the mesh is as it was.
/// If `keeps_most`, closed groups are not turned outwards either: they look the way most of their
/// faces did.
std::size_t orient_faces(Mesh& mesh, bool keeps_most = false);

/// Whether orient_faces() leaves no edge at which faces are misoriented (orientation_check.h).
bool can_be_oriented(Mesh mesh);

}  // namespace transformesh

/// Splits faces along self-intersections and removes nothing: the arrangement of paper 3.2.3 as a
/// mesh. Afterwards faces meet in common vertices and edges only (up to rounding of new vertices),
/// and faces that overlapped in a plane have coincident pieces.
///
/// Whole faces come first, in their order; the pieces of cut faces follow. Vertices keep their
/// order, and new ones follow. New vertices interpolate their columns in a face on which they lie,
/// and pieces inherit those of the face that they are cut from; the face column `source_face` names
/// it. Faces without area are dropped. Throws InputError where faces intersect and a coordinate is
/// beyond 1e306.
///
/// Exact but for the rounding; deterministic. Cost: that of finding and arranging intersections.
#pragma once

#include "transformesh/intersect.h"
#include "transformesh/mesh.h"

namespace transformesh {

Mesh refine(const Mesh& mesh, const Progress& progress = Progress());

/// The row of a new vertex at a position on a face: the face's corners with barycentric weights.
/// These are in [0, 1] and sum to 1, whatever rounding did to the position.
RowBlend row_on_face(const Mesh& mesh, Index face, const Vec3& position);

}  // namespace transformesh

/// Splits faces along self-intersections and removes nothing: the arrangement of paper 3.2.3 as a
/// mesh. Afterwards faces meet in common vertices and edges only, except for rounding of new
/// vertices. If coplanar faces overlap, each of them has its own pieces, and these coincide.
///
/// Faces without intersections come first, in their order; the pieces of cut faces follow. Vertices
/// keep their order; new vertices follow. A new vertex interpolates its columns in a face that
/// contains it. A piece inherits the columns of its face; the face column `source_face` holds the
/// index of that face. Faces without area are dropped. Throws InputError if faces intersect and a
/// coordinate exceeds 1e306.
///
/// Exact except for the rounding; deterministic. The cost is that of finding and arranging the
/// intersections.
#pragma once

#include "transformesh/intersect.h"
#include "transformesh/mesh.h"

namespace transformesh {

Mesh refine(const Mesh& mesh, const Progress& progress = Progress());

/// Returns the corners of the face with the barycentric weights of `position`, for interpolating
/// the attributes (columns) of vertices. The weights are in [0, 1] and sum to 1, even if rounding
/// moved the position off the face.
RowBlend row_on_face(const Mesh& mesh, Index face, const Vec3& position);

}  // namespace transformesh

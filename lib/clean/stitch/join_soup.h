/// Makes a mesh of what only indices keep apart: if border edges lie upon each other
/// (touching_borders.h), equal places become one vertex as by stitch(). Any other mesh, closed or
/// open, stays as it is.
#pragma once

#include "clean/stitch/stitch.h"

namespace transformesh {

/// Returns what stitch() did; no `joined_vertices` if the mesh is unchanged. Throws InputError if
/// faces that come to meet traverse an edge in the same direction, with the place and what mends
/// it. O(n), O(n log n) if it joins.
StitchResult join_soup(Mesh& mesh);

}  // namespace transformesh

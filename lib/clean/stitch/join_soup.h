/// Joins a triangle soup: if border edges coincide (touching_borders.h), vertices with equal
/// positions are merged as by stitch(). Any other mesh, closed or open, does not change.
#pragma once

#include "transformesh/stitch.h"

namespace transformesh {

/// Returns the result of stitch(); `joined_vertices` is 0 if the mesh is unchanged. Throws
/// InputError if joined faces traverse an edge in the same direction; the error names the place.
/// O(n), or O(n log n) if vertices are joined.
StitchResult join_soup(Mesh& mesh);

}  // namespace transformesh

/// Joins a triangle soup, whose triangles share no vertices. If border edges of a mesh coincide
/// (touching_borders.h), its vertices with equal positions are merged as stitch() does. Any other
/// mesh, closed or open, does not change, and neither does a mesh of open bodies that only touch at
/// their borders.
#pragma once

#include "transformesh/stitch.h"

namespace transformesh {

/// True if the surface continues across border edges that coincide.
bool is_soup(const Mesh& mesh);

/// Returns the result of stitch(); `joined_vertices` is 0 if the mesh is unchanged. Throws
/// InputError if two neighboring faces would traverse their common edge in the same direction; the
/// error names the edge. O(n), or O(n log n) if vertices are joined.
StitchResult join_soup(Mesh& mesh);

}  // namespace transformesh

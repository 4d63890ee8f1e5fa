/// Cleans the faces of `box` (paper 4.6). The faces of the box are replaced by the pieces that
/// clean() of the whole mesh would keep. All other faces keep their vertices, columns and order,
/// even if they intersect faces of the box. The winding numbers are those of the whole mesh. With
/// `only`, the result contains only the pieces. Then a large box is divided into parts that are
/// cleaned one after the other, and vertices between two parts are duplicated.
///
/// Guarantee for a mesh that is divided into boxes: if rounding breaks no face, the pieces of all
/// boxes together are the triangles of clean(), coordinate by coordinate. Rounding breaks a face if
/// the face intersects another one, or has no area, after rounding. If this happens in a box, its
/// pieces are taken from the cleaned whole mesh (`is_whole`). Then the pieces of neighboring boxes
/// can differ from that mesh, because repair after rounding may reach farther than two rings of
/// faces. Deterministic for any number of threads.
///
/// Throws UsageError if the box is empty. Throws InputError if the mesh has borders or is not
/// oriented, which a hash of its edges decides. Throws GoalError as clean() does. Cost: O(n log n)
/// for the mesh, and that of clean() for the faces in and around the box. Memory: about 5 bytes per
/// face of the mesh, and 300 bytes per face in and around the box. With `only`, the 300 bytes are
/// needed for one part of the box at a time, with at most 262144 faces.
#pragma once

#include "clean/box/tile.h"
#include "transformesh/clean.h"

namespace transformesh {

/// Uses `box`, `only`, `winding_level`, `refuse` and `coordinate` of the options.
CleanResult clean_box(const Mesh& mesh, const CleanOptions& options, const Progress& progress);

/// Cleans the own faces of a tile (tile.h), which no other tile cleans. The result is that of
/// clean_box() with `only` in the whole mesh. Uses `winding_level`, `refuse` and `coordinate` of
/// the options. Throws UsageError if other options are set, and InputError if the mesh is not the
/// tile. Throws GoalError if faces outside the tile are needed: if rounding breaks faces, or if
/// coplanar faces extend far beyond the tile.
CleanResult clean_tile(const Mesh& mesh, const Tile& tile, const CleanOptions& options,
                       const Progress& progress);

}  // namespace transformesh

/// Cleans the faces of `box` (paper 4.6). The faces of the box are replaced by the pieces that
/// clean() of the whole mesh would keep. All other faces keep their vertices, columns and order,
/// even if they intersect faces of the box. The winding numbers are those of the whole mesh. With
/// `only`, the result contains the pieces alone. It is computed for one part of the box at a time,
/// and vertices at the seams of these parts are duplicated.
///
/// Guarantee for a mesh that is divided into boxes: if rounding breaks no face, the pieces of all
/// boxes together are the triangles of clean(), coordinate by coordinate. If rounding breaks a
/// face, the pieces are taken from the cleaned whole mesh (`is_whole`). Then neighboring boxes can
/// differ from that mesh if rounding was repaired more than two rings of faces away. Deterministic
/// for any number of threads.
///
/// Throws UsageError if the box is empty. Throws InputError if the mesh has borders or is not
/// oriented, which a hash of its edges decides. Throws GoalError as clean() does. Cost: O(n log n)
/// for the mesh, and that of clean() for the faces in and around the box. Memory: about 5 bytes per
/// face of the mesh, and 300 bytes per face in and around the box. With `only`, the latter is
/// limited to one part of at most 262144 faces.
#pragma once

#include "clean/box/tile.h"
#include "transformesh/clean.h"

namespace transformesh {

/// Uses `box`, `only`, `winding_level`, `refuse` and `coordinate` of the options.
CleanResult clean_box(const Mesh& mesh, const CleanOptions& options, const Progress& progress);

/// Cleans the own faces of a tile as clean_box() does with `only` in the whole mesh. Uses
/// `winding_level`, `refuse` and `coordinate` of the options. Throws UsageError if others are set,
/// and InputError if the mesh is not the tile. Throws GoalError if faces outside the tile are
/// needed: if rounding breaks faces, or if coplanar faces extend far beyond the tile.
CleanResult clean_tile(const Mesh& mesh, const Tile& tile, const CleanOptions& options,
                       const Progress& progress);

}  // namespace transformesh

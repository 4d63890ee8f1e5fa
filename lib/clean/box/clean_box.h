/// Cleans the faces of `box` (paper 4.6). Faces of the box are replaced by those of their pieces
/// that clean() of the whole mesh would keep. All other faces keep vertices, columns and order,
/// even if they intersect faces of the box. The winding numbers are those of the whole mesh. With
/// `only`, the result is the pieces alone, made a part of the box at a time; vertices are double
/// at the seams of these parts.
///
/// Guarantee: if rounding breaks no face in any of the boxes that a mesh is divided into, their
/// pieces together are the triangles of clean(), coordinate by coordinate. If rounding breaks a
/// face, the pieces are taken from the cleaned whole mesh (`is_whole`). Neighboring boxes can then
/// differ from that mesh where rounding was repaired more than two rings of faces away.
/// Deterministic for any number of threads.
///
/// Throws UsageError (a box without inside), InputError (the mesh has borders or is not oriented,
/// as decided by a hash of its edges), GoalError as clean() does. Cost: O(n log n) for the mesh,
/// and that of clean() for the faces in and around the box. Memory: about 5 bytes per face of the
/// mesh, and 300 per face in and around the box; with `only`, per face of one part of 65536 faces.
#pragma once

#include "clean/box/tile.h"
#include "transformesh/clean.h"

namespace transformesh {

/// Uses `box`, `only`, `winding_level`, `refuse` and `coordinate` of the options.
CleanResult clean_box(const Mesh& mesh, const CleanOptions& options, const Progress& progress);

/// Cleans the own faces of a tile as clean_box() does with `only` in the whole mesh. Uses
/// `winding_level`, `refuse` and `coordinate` of the options. Throws UsageError if others are set,
/// and InputError if the mesh is not the tile. Throws GoalError if faces are needed that are not in
/// the tile: if rounding breaks faces, or if faces in one plane reach far beyond the tile.
CleanResult clean_tile(const Mesh& mesh, const Tile& tile, const CleanOptions& options,
                       const Progress& progress);

}  // namespace transformesh

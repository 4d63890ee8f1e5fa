/// Double-sided models, in which faces come with their reverses, so that they enclose nothing:
/// usual in graphics, where only the front of a face is drawn. Faces are each other's reverse where
/// their corners are at equal positions and have the opposite direction. Deterministic; O(n log n).
#pragma once

#include <cstddef>

#include "transformesh/mesh.h"

namespace transformesh {

/// How many faces have a reverse.
std::size_t count_double_sided(const Mesh& mesh);

/// Whether the faces that drop_reverses() leaves, equal positions being one vertex, have a border.
bool one_side_is_open(const Mesh& mesh);

/// Drops all but the first of faces that lie upon each other, where some of these are reversed.
/// Vertices are the same when their indices are. Columns follow; vertices stay. Returns how many
/// went.
std::size_t drop_reverses(Mesh& mesh);

/// Drops all but the first of faces that lie upon each other and have the same direction. Vertices
/// are the same when their indices are. Columns follow; vertices stay. Returns how many went.
std::size_t drop_copies(Mesh& mesh);

/// Reverses the connected components that are closed and have a negative volume; returns how many
/// faces that were.
std::size_t turn_outwards(Mesh& mesh);

}  // namespace transformesh

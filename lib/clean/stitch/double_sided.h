/// Double-sided models, in which each face has a duplicate with opposite orientation, so that they
/// enclose nothing: usual in graphics, where only the front of a face is drawn. Two faces are each
/// other's reverse if their corners are at equal positions in opposite order. Deterministic; O(n
/// log n).
#pragma once

#include <cstddef>

#include "mesh/mesh.h"

namespace transformesh {

/// How many faces have a reverse.
std::size_t count_double_sided(const Mesh& mesh);

/// Whether the faces that drop_reverses() leaves, equal positions being one vertex, have a border.
bool one_side_is_open(const Mesh& mesh);

/// Drops all but the first of faces that lie upon each other, where some of these are reversed.
/// Vertices are the same when their indices are. Columns follow; vertices stay. Returns how many
/// went.
std::size_t drop_reverses(Mesh& mesh);

/// Reverses the connected components that are closed and have a negative volume; returns how many
/// faces that were.
std::size_t turn_outwards(Mesh& mesh);

}  // namespace transformesh

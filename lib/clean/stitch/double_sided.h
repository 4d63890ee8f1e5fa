/// Double-sided models: each face has a reverse, so the faces enclose nothing. Such models are
/// common in graphics, where only the front of a face is drawn. Two faces are reverses of each
/// other if their corners have equal positions and opposite orientation. Deterministic; O(n log n).
#pragma once

#include <cstddef>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns the number of faces that have a reverse.
std::size_t count_double_sided(const Mesh& mesh);

/// True if the mesh has a border after drop_reverses() with equal positions welded.
bool one_side_is_open(const Mesh& mesh);

/// Keeps only the first of each set of coincident faces that contains reverses, and drops the
/// others. Vertices are equal if their indices are. Columns follow; vertices stay. Returns the
/// number of dropped faces.
std::size_t drop_reverses(Mesh& mesh);

/// Keeps only the first of coincident faces with the same orientation, and drops the others.
/// Vertices are equal if their indices are. Columns follow; vertices stay. Returns the number of
/// dropped faces.
std::size_t drop_copies(Mesh& mesh);

/// Reverses the closed components with negative volume. Returns the number of reversed faces.
std::size_t turn_outwards(Mesh& mesh);

}  // namespace transformesh

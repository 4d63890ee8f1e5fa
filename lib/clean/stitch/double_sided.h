/// Finds and repairs double-sided models. In such a model each face has a reverse: a face with
/// corners at the same positions, and with opposite orientation. Hence the faces enclose nothing.
/// Such models are common in graphics, where only the front of a face is drawn. Deterministic; O(n
/// log n).
#pragma once

#include <cstddef>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns the number of faces that have a reverse: a face with the same corners and opposite
/// orientation.
std::size_t count_double_sided(const Mesh& mesh);

/// True if the mesh is double-sided: it encloses its volume only after one of two coincident faces
/// with opposite orientations (reverses) is removed. Vertices within `tolerance` count as merged.
/// Otherwise such faces are walls between bodies that touch, and winding numbers do not count them.
/// One side must be removed in two cases. Either all faces of a connected part coincide with
/// others, some with opposite orientations. Or fewer edges have an odd number of faces if only one
/// of coincident faces stays, also compared with the mesh without copies of the same orientation.
bool needs_one_side(const Mesh& mesh, double tolerance = 0);

/// True if the mesh would have a border after two steps: vertices at equal positions are merged,
/// and drop_reverses() keeps one of coincident faces with opposite orientations. Does not change
/// the mesh.
bool one_side_is_open(const Mesh& mesh);

/// Removes the reverses of faces, which have the same corners and opposite orientation. If a set of
/// coincident faces has both orientations, only its first face stays. Faces coincide if they have
/// the same vertex indices. Face columns are updated; vertices stay. Returns the number of dropped
/// faces.
std::size_t drop_reverses(Mesh& mesh);

/// Keeps only the first of coincident faces with the same orientation, and drops the others. With
/// `drops_walls`, drops all of them if they are a wall between bodies, of which some are inside
/// out: their other faces are neighbors without the wall. Faces coincide if they have the same
/// vertex indices. Face columns are updated; vertices stay. Returns the number of dropped faces.
std::size_t drop_copies(Mesh& mesh, bool drops_walls = false);

/// Reverses the faces of closed components with negative volume. Returns the number of reversed
/// faces.
std::size_t turn_outwards(Mesh& mesh);

}  // namespace transformesh

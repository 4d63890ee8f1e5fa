/// Prepares targets for searches, and stores normals of points as columns.
#pragma once

#include <vector>

#include "transformesh/target.h"

namespace transformesh {

/// Sorts the faces of a target spatially unless they are sorted, and drops their columns. Among
/// faces at the same distance the first one wins: the order of faces decides about last digits.
void order_spatially(Target& target);

/// Returns the vertex columns nx ny nz, of unit length or zero, or nothing if one is missing.
/// Throws InputError for normals that are not finite.
std::vector<Vec3> stored_normals(const Mesh& mesh);

/// Stores normals as the vertex columns nx ny nz, which make_target() reads for points.
void set_normal_columns(Mesh& mesh, const std::vector<Vec3>& normals);

}  // namespace transformesh

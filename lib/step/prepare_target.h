/// Prepares targets for searches, and stores normals of points as columns.
#pragma once

#include <vector>

#include "transformesh/target.h"

namespace transformesh {

/// Sorts the faces of a target spatially and drops their columns; does nothing if they are already
/// sorted. A search returns the first of several faces at equal distance, so the order of the faces
/// can change the last digits of a result.
void order_spatially(Target& target);

/// Returns the normals in the vertex columns nx, ny and nz, scaled to unit length; zero stays zero.
/// Returns an empty vector if a column is missing.
/// Throws InputError for normals that are not finite.
std::vector<Vec3> stored_normals(const Mesh& mesh);

/// Stores normals as the vertex columns nx, ny and nz. make_target() reads these columns if the
/// mesh has no faces.
void set_normal_columns(Mesh& mesh, const std::vector<Vec3>& normals);

}  // namespace transformesh

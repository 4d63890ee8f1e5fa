/// Corrections of velocities and displacements that keep the volume of each component of a closed
/// mesh.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Throws InputError (not_closed) if an edge has only one face.
void require_volume(const Mesh& mesh);

/// Changes `velocities` so that the volume of each component has derivative zero. For this purpose,
/// adds a motion along the normals, with one speed per component.
void remove_volume_rates(const Mesh& mesh, std::vector<Vec3>& velocities);

/// Adds `directions` times one factor per component to `displacements`, so that each component has
/// the same volume as in `mesh`, up to rounding. A component whose volume does not grow along the
/// directions, for example because it is inside out, stays as it is.
void restore_volumes(const Mesh& mesh, const std::vector<Vec3>& directions,
                     std::vector<Vec3>& displacements);

}  // namespace transformesh

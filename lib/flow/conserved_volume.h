/// Corrections that keep the volume of each component of a closed mesh.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Throws InputError (not_closed) unless every edge has two faces.
void require_volume(const Mesh& mesh);

/// Adds to the velocities a motion along the normals, of one speed per component, after which the
/// derivative of the volume of each component is zero.
void remove_volume_rates(const Mesh& mesh, std::vector<Vec3>& velocities);

/// Adds to the displacements the directions times one factor per component, after which each
/// component has its volume again, up to rounding. A component whose volume does not grow along the
/// directions, as if it is inside out, stays as it is.
void restore_volumes(const Mesh& mesh, const std::vector<Vec3>& directions,
                     std::vector<Vec3>& displacements);

}  // namespace transformesh

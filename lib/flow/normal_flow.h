/// Motion along the normals at a given speed: growth if the speed is positive, erosion if it is
/// negative (Huygens' principle).
///
/// A vertex moves so that the planes of its faces move at the speed, which keeps edges sharp. The
/// exceptions are convex vertices that grow and concave vertices that recede. There the exact
/// surface becomes round, and the vertex moves along its normal at the speed. Cost: O(n).
/// Reference: Jiao, "Face offsetting: a unified approach for explicit moving interfaces", Journal
/// of Computational Physics 220, 2007.
/// For round and sharp places: Sethian, "Level Set Methods and Fast Marching Methods", Cambridge
/// University Press 1999, chapter 2.
#pragma once

#include <span>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns the velocity of each vertex, given one speed per vertex. Throws InputError for
/// coincident borders.
std::vector<Vec3> huygens_velocities(const Mesh& mesh, std::span<const double> speeds);

}  // namespace transformesh

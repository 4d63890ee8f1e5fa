/// Solids defined by distance functions, meshed by marching on a lattice and relaxed on the exact
/// surface.
#pragma once

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh::shapes {

Mesh ellipsoid(const Vec3& axes, std::size_t faces, const Progress& progress);

/// Returns a rounded plate, 2.4 wide, with this many holes: up to two in a row, more in a ring.
Mesh genus(long holes, std::size_t faces, const Progress& progress);

/// Returns two balls of radius 0.5 along z, joined by a neck of this radius. If `neck` is negative,
/// the x coordinates in the middle of the neck are negated. The sides of the neck then pass through
/// each other at two heights, and the surface between these is inverted. 0.01 <= |neck| <= 0.45.
Mesh dumbbell(double neck, std::size_t faces, const Progress& progress);

/// Returns a thick half shell with a rounded rim, open upwards.
Mesh bowl(std::size_t faces, const Progress& progress);

}  // namespace transformesh::shapes

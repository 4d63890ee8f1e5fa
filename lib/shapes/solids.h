/// Solids known by a distance: meshed by marching on a lattice and relaxed on the exact surface.
#pragma once

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh::shapes {

Mesh ellipsoid(const Vec3& axes, std::size_t faces, const Progress& progress);

/// A rounded plate, 2.4 wide, with that many holes: in a row up to two, else in a ring.
Mesh genus(long holes, std::size_t faces, const Progress& progress);

/// Two balls of radius 0.5 along z, joined by a neck. A negative neck is the positive one with its
/// middle mirrored in x: the two sides have passed through each other, and between the two places
/// where they cross lies inverted space. 0.01 <= |neck| <= 0.45.
Mesh dumbbell(double neck, std::size_t faces, const Progress& progress);

/// A thick half shell with a rounded rim, open upwards.
Mesh bowl(std::size_t faces, const Progress& progress);

}  // namespace transformesh::shapes

/// Boxes: one, and many on the integer lattice.
#pragma once

#include <cstdint>

#include "transformesh/mesh.h"

namespace transformesh::shapes {

/// Centered at the origin, with those edges; each side is a grid of squares or nearly so, cut in
/// two along alternating diagonals.
Mesh box(const Vec3& edges, std::size_t faces);

/// `count` boxes of 12 faces with integer corners, so dense that sides are coplanar, coincide, and
/// meet in edges and corners.
Mesh boxes(std::size_t count, std::uint64_t seed);

}  // namespace transformesh::shapes

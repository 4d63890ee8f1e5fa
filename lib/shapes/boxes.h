/// A single box, and random boxes with integer corners.
#pragma once

#include <cstdint>

#include "transformesh/mesh.h"

namespace transformesh::shapes {

/// Returns a box with about `faces` triangles, centered at the origin, with these edge lengths.
/// Each side is a grid of almost square cells, divided along alternating diagonals.
Mesh box(const Vec3& edges, std::size_t faces);

/// Returns `count` boxes of 12 faces with integer corners. They are so dense that sides are
/// coplanar, coincide, and meet in edges and corners.
Mesh boxes(std::size_t count, std::uint64_t seed);

}  // namespace transformesh::shapes

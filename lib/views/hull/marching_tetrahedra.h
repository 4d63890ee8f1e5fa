/// Triangulates the surface where values on a grid change sign, by marching tetrahedra.
/// Reference: Doi & Koide, "An efficient method of triangulating equi-valued surfaces by using
/// tetrahedral cells", IEICE Transactions 1991. Each cube of the grid is divided into Kuhn's six
/// tetrahedra around its diagonal, which match those of adjacent cubes.
#pragma once

#include <array>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

struct ValueGrid {
  Vec3 origin = Vec3::Zero();          ///< position of node (0, 0, 0)
  double spacing = 1;                  ///< distance between neighboring nodes, > 0
  std::array<std::size_t, 3> nodes{};  ///< number of nodes along x, y and z
  /// Values at the nodes: finite, negative inside the surface; x varies fastest.
  std::vector<float> values;

  std::size_t index(std::size_t x, std::size_t y, std::size_t z) const {
    return (z * nodes[1] + y) * nodes[0] + x;
  }
  Vec3 position(std::size_t x, std::size_t y, std::size_t z) const {
    return origin +
           spacing * Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
  }
};

/// Returns a closed, oriented 2-manifold without self-intersection for any values, because each
/// tetrahedron contains at most two faces, which then share an edge. Values on the boundary of the
/// grid must not be negative. A vertex lies on an edge of the grid where the linearly interpolated
/// value is zero. Its distance from the ends of the edge is at least a twentieth of the edge
/// length, so that no face is degenerate. The mesh is empty if no value is negative. O(nodes + f
/// log f) for f faces. Parallel; the result does not depend on the number of threads.
Mesh march_tetrahedra(const ValueGrid& grid);

}  // namespace transformesh

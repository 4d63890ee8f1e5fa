/// The surface on which values on a grid change sign, by marching tetrahedra.
/// Reference: Doi & Koide, "An efficient method of triangulating equi-valued surfaces by using
/// tetrahedral cells", IEICE Transactions 1991. Each cube of the grid is cut into Kuhn's six
/// tetrahedra around its diagonal, which fit those of the cubes beside it.
#pragma once

#include <array>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

struct ValueGrid {
  Vec3 origin = Vec3::Zero();          ///< position of node 0, 0, 0
  double spacing = 1;                  ///< > 0, between neighbors
  std::array<std::size_t, 3> nodes{};  ///< their number along x, y and z
  std::vector<float> values;           ///< finite, negative inside; x runs fastest

  std::size_t index(std::size_t x, std::size_t y, std::size_t z) const {
    return (z * nodes[1] + y) * nodes[0] + x;
  }
  Vec3 position(std::size_t x, std::size_t y, std::size_t z) const {
    return origin +
           spacing * Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
  }
};

/// A closed, oriented 2-manifold without self-intersection, whatever the values: each face lies in
/// its own tetrahedron. Nodes on the boundary of the grid must not be negative. A vertex lies on an
/// edge of the grid where the value is zero, interpolated, but no closer to the edge's ends than a
/// twentieth of it, so that no face degenerates. Empty where nothing is inside.
/// O(nodes), parallel; the same mesh for any number of threads.
Mesh march_tetrahedra(const ValueGrid& grid);

}  // namespace transformesh

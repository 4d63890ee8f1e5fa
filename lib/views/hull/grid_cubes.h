/// Building blocks of marching tetrahedra: computes the faces in one cube of the grid, and the
/// vertices of faces. They do not depend on how the values at grid nodes are stored, and are shared
/// by marching_tetrahedra.h and distance_blocks.h. The surface has holes at nodes whose value is
/// unknown.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// A regular grid: positions and indices of its nodes.
struct NodeGrid {
  Vec3 origin = Vec3::Zero();          ///< position of node (0, 0, 0)
  double spacing = 1;                  ///< distance between neighboring nodes, > 0
  std::array<std::size_t, 3> nodes{};  ///< number of nodes along x, y and z

  /// Returns the index of a node; x varies fastest.
  std::size_t index(std::size_t x, std::size_t y, std::size_t z) const {
    return (z * nodes[1] + y) * nodes[0] + x;
  }
  Vec3 position(std::size_t x, std::size_t y, std::size_t z) const {
    return origin +
           spacing * Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
  }
};

/// Identifies an edge of a tetrahedron: eight times the index of its first node, plus 1, 2 and 4 if
/// the edge extends along x, y and z.
using EdgeKey = std::uint64_t;
/// A triangle of the surface, given by the edges on which its three vertices lie.
using EdgeKeyFace = std::array<EdgeKey, 3>;

/// A cube of the grid. In the index of a corner, bits 0, 1 and 2 are its position along x, y and z.
struct GridCube {
  std::array<std::size_t, 8> nodes{};
  /// Values at the corners: negative inside the surface; NaN if unknown.
  std::array<float, 8> values{};
};

/// Appends to `faces` the triangles in the six tetrahedra of the cube. Skips tetrahedra with a
/// corner of unknown value.
void cut_cube(const GridCube& cube, std::vector<EdgeKeyFace>& faces);

/// Returns the mesh of all `faces`. Its vertices have the order of their edge keys. `value` returns
/// the value at a node. Parallel; the result does not depend on the number of threads.
Mesh mesh_of_cut_edges(const NodeGrid& grid, const std::vector<EdgeKeyFace>& faces,
                       const std::function<float(std::size_t node)>& value);

}  // namespace transformesh

/// Parts of marching tetrahedra (marching_tetrahedra.h) that do not depend on how values are
/// stored: faces in a cube of the grid, and their vertices. Nodes of unknown value leave the
/// surface open.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Positions and numbers of the nodes of a grid.
struct NodeGrid {
  Vec3 origin = Vec3::Zero();          ///< position of node (0, 0, 0)
  double spacing = 1;                  ///< distance between neighboring nodes, > 0
  std::array<std::size_t, 3> nodes{};  ///< number of nodes along x, y and z

  /// Returns the number of a node; x varies fastest.
  std::size_t index(std::size_t x, std::size_t y, std::size_t z) const {
    return (z * nodes[1] + y) * nodes[0] + x;
  }
  Vec3 position(std::size_t x, std::size_t y, std::size_t z) const {
    return origin +
           spacing * Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
  }
};

/// Identifies an edge of the grid: eight times its first node, plus 1, 2 and 4 if the edge extends
/// along x, y and z.
using EdgeKey = std::uint64_t;
/// A face by the edges of the grid on which its vertices lie.
using EdgeKeyFace = std::array<EdgeKey, 3>;

/// A cube of the grid. Corners are numbered by bits x, y, z.
struct GridCube {
  std::array<std::size_t, 8> nodes{};
  std::array<float, 8> values{};  ///< negative inside; not a number if unknown
};

/// Appends the faces in the cube's tetrahedra, except for tetrahedra with an unknown corner.
void cut_cube(const GridCube& cube, std::vector<EdgeKeyFace>& faces);

/// Returns the mesh of these faces, with vertices in the order of their edges. `value` returns the
/// value of a node. Parallel; the result does not depend on the number of threads.
Mesh mesh_of_cut_edges(const NodeGrid& grid, const std::vector<EdgeKeyFace>& faces,
                       const std::function<float(std::size_t node)>& value);

}  // namespace transformesh

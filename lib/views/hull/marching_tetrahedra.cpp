#include "views/hull/marching_tetrahedra.h"

#include <algorithm>

#include "support/parallel.h"
#include "views/hull/grid_cubes.h"

namespace transformesh {
namespace {

GridCube cube_at(const ValueGrid& grid, std::size_t base) {
  GridCube cube;
  for (unsigned corner = 0; corner < 8; ++corner) {
    cube.nodes[corner] = base + grid.index(corner & 1, corner >> 1 & 1, corner >> 2);
    cube.values[corner] = grid.values[cube.nodes[corner]];
  }
  return cube;
}

std::vector<EdgeKeyFace> faces_of_layer(const ValueGrid& grid, std::size_t z) {
  std::vector<EdgeKeyFace> faces;
  for (std::size_t y = 0; y + 1 < grid.nodes[1]; ++y)
    for (std::size_t x = 0; x + 1 < grid.nodes[0]; ++x)
      cut_cube(cube_at(grid, grid.index(x, y, z)), faces);
  return faces;
}

std::vector<EdgeKeyFace> all_faces(const ValueGrid& grid) {
  const std::size_t layers = grid.nodes[2] - 1;
  std::vector<std::vector<EdgeKeyFace>> of_layer(layers);
  parallel_for(layers, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t z = first; z < last; ++z) of_layer[z] = faces_of_layer(grid, z);
  });
  std::vector<EdgeKeyFace> faces;
  for (const std::vector<EdgeKeyFace>& some : of_layer)
    faces.insert(faces.end(), some.begin(), some.end());
  return faces;
}

}  // namespace

Mesh march_tetrahedra(const ValueGrid& grid) {
  if (*std::min_element(grid.nodes.begin(), grid.nodes.end()) < 2) return {};
  return mesh_of_cut_edges({grid.origin, grid.spacing, grid.nodes}, all_faces(grid),
                           [&](std::size_t node) { return grid.values[node]; });
}

}  // namespace transformesh

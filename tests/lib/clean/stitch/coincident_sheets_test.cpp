#include "clean/stitch/coincident_sheets.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"
#include "mesh/adjacency.h"

using namespace transformesh;

namespace {

std::vector<Index> layers_of(const Mesh& mesh) {
  return neighbors_in_layers(mesh, Edges(mesh.faces, mesh.positions.size()));
}

/// Appends faces of `mesh` a second time, on the same vertices.
Mesh with_copy(Mesh mesh, bool is_reversed) {
  const std::vector<Face> faces = mesh.faces;
  for (const auto& [a, b, c] : faces)
    mesh.faces.push_back(is_reversed ? Face{a, c, b} : Face{a, b, c});
  return mesh;
}

}  // namespace

TEST_CASE("a surface without copies has the neighbors across its edges") {
  const Mesh mesh = test::icosphere(1);
  CHECK(layers_of(mesh) == opposite_halfedges(mesh));
}

TEST_CASE("two copies of a sphere stay apart, each connected in itself") {
  for (const bool is_reversed : {false, true}) {
    const Mesh sphere = test::icosphere(1);
    const Mesh mesh = with_copy(sphere, is_reversed);
    const std::size_t half = 3 * sphere.faces.size();
    const std::vector<Index> neighbors = layers_of(mesh);
    for (std::size_t h = 0; h < neighbors.size(); ++h) {
      REQUIRE(neighbors[h] != no_index);
      CHECK((neighbors[h] < half) == (h < half));
      CHECK(neighbors[neighbors[h]] == h);
    }
  }
}

TEST_CASE("an edge of three different faces continues no surface") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}};
  mesh.faces = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  const std::vector<Index> neighbors = layers_of(mesh);
  CHECK(neighbors[0] == no_index);
  CHECK(neighbors[3] == no_index);
  CHECK(neighbors[6] == no_index);
}

TEST_CASE("copies of two faces continue each other only if there are as many of each") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  mesh.faces = {{0, 1, 2}, {1, 0, 3}, {0, 1, 2}};
  CHECK(layers_of(mesh)[0] == no_index);
  mesh.faces.push_back({1, 0, 3});
  const std::vector<Index> neighbors = layers_of(mesh);
  CHECK(neighbors[0] == 3);
  CHECK(neighbors[6] == 9);
}

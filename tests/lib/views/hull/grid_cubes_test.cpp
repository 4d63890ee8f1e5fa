#include "views/hull/grid_cubes.h"

#include <doctest/doctest.h>

#include <limits>

#include "helpers/mesh_facts.h"
#include "transformesh/measure.h"

using namespace transformesh;

namespace {

const NodeGrid grid{Vec3(1, 2, 3), 0.5, {2, 2, 2}};

/// Returns the mesh of one cube with these values of its corners.
Mesh mesh_of(const std::array<float, 8>& values) {
  GridCube cube;
  cube.values = values;
  for (std::size_t corner = 0; corner < 8; ++corner) cube.nodes[corner] = corner;
  std::vector<EdgeKeyFace> faces;
  cut_cube(cube, faces);
  return mesh_of_cut_edges(grid, faces, [&](std::size_t node) { return values[node]; });
}

constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

}  // namespace

TEST_CASE("a plane across a cube has the area of the square, at the interpolated height") {
  const Mesh mesh = mesh_of({-1, -1, -1, -1, 3, 3, 3, 3});
  CHECK(surface_area(mesh) == doctest::Approx(0.25));
  for (const Vec3& position : mesh.positions) CHECK(position.z() == doctest::Approx(3.125));
  for (Index f = 0; f < mesh.faces.size(); ++f) CHECK(face_normal(mesh, f).z() > 0);
}

TEST_CASE("tetrahedra with an unknown corner have no faces") {
  const Mesh whole = mesh_of({-1, -1, -1, -1, 3, 3, 3, 3});
  // Corner 1 belongs to two of the six tetrahedra.
  const Mesh part = mesh_of({-1, unknown, -1, -1, 3, 3, 3, 3});
  CHECK(part.faces.size() < whole.faces.size());
  CHECK(part.faces.size() > 0);
  CHECK(surface_area(part) < surface_area(whole));
  // Corners 0 and 7 belong to all.
  CHECK(mesh_of({unknown, -1, -1, -1, 3, 3, 3, 3}).faces.empty());
  CHECK(mesh_of({-1, -1, -1, -1, 3, 3, 3, unknown}).faces.empty());
}

TEST_CASE("cubes on one side have no faces") {
  CHECK(mesh_of({1, 1, 1, 1, 3, 3, 3, 3}).faces.empty());
  CHECK(mesh_of({-1, -1, -1, -1, -3, -3, -3, -3}).faces.empty());
}

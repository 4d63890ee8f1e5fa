/// Collapses in stars of thousands of faces, on a double cone: one star above a rim and one below.
#include "remesh/operations/high_valence_collapse.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "helpers/shapes.h"
#include "transformesh/intersect.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"

using namespace transformesh;

namespace {

constexpr Index rim = 3000;

Mesh double_cone() {
  Mesh mesh;
  mesh.positions = {{0, 0, 1}, {0, 0, -1}};
  for (Index i = 0; i < rim; ++i) {
    const double angle = 2 * std::numbers::pi * i / rim;
    mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  for (Index i = 0; i < rim; ++i) {
    const Index here = 2 + i, next = 2 + (i + 1) % rim;
    mesh.faces.push_back({0, here, next});
    mesh.faces.push_back({1, next, here});
  }
  return mesh;
}

/// Tetrahedra inside that are nearer to the rim than the chords of a rim with fewer vertices.
Mesh with_splinters(Mesh mesh) {
  for (int i = 0; i < 7; ++i) {
    const Vec3 out(std::cos(i), std::sin(i), 0), side(-std::sin(i), std::cos(i), 0);
    Mesh splinter;
    splinter.positions = {(1 - 2e-6) * out, 0.99 * out + 1e-3 * side, 0.99 * out + Vec3(0, 0, 1e-3),
                          0.99 * out};
    splinter.faces = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
    mesh = test::joined(mesh, splinter);
  }
  return mesh;
}

}  // namespace

TEST_CASE("stars of very many faces are thinned, and the surface stays where it was") {
  EditableMesh mesh(double_cone());
  const std::size_t done = collapse_high_valence_stars(mesh, false, {0.1, 0.5}, Progress());
  CHECK(mesh.valence(0) == 256);
  CHECK(mesh.valence(1) == 256);
  CHECK(done == rim - 256);
  const Mesh thinned = mesh.to_mesh();
  const ManifoldReport found = check_manifold(thinned);
  CHECK((found.is_manifold() && found.is_oriented() && found.is_closed()));
  CHECK(find_intersections(thinned).empty());
  CHECK(volume(thinned) == doctest::Approx(volume(double_cone())).epsilon(1e-3));
}

TEST_CASE("a mesh that would intersect itself keeps its stars") {
  const Mesh input = with_splinters(double_cone());
  REQUIRE(find_intersections(input).empty());
  EditableMesh mesh(input);
  CHECK(collapse_high_valence_stars(mesh, false, {0.1, 0.5}, Progress()) == 0);
  CHECK(mesh.to_mesh().faces == input.faces);
}

TEST_CASE("usual meshes and long edges are left alone") {
  EditableMesh ball(test::icosphere(4));
  CHECK(collapse_high_valence_stars(ball, false, {0.5, 1}, Progress()) == 0);
  EditableMesh cone(double_cone());
  CHECK(collapse_high_valence_stars(cone, false, {1e-4, 1e-3}, Progress()) == 0);
  CHECK(cone.valence(0) == rim);
}

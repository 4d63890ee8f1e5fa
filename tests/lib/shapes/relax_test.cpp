#include "shapes/relax.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "helpers/mesh_facts.h"
#include "helpers/random.h"
#include "helpers/shapes.h"
#include "support/parallel.h"
#include "transformesh/control.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

Vec3 onto_sphere(const Vec3& point) { return point.normalized(); }

/// A sphere whose vertices were moved at random along it by up to a third of an edge.
Mesh shaken_sphere() {
  Mesh mesh = icosphere(3);
  Random random(7);
  const double reach = 0.33 * mean_edge(mesh);
  for (Vec3& point : mesh.positions) point = onto_sphere(point + random.point(-reach, reach));
  return mesh;
}

}  // namespace

TEST_CASE("triangles become even, on the surface, with the same counts and genus") {
  const Mesh before = shaken_sphere();
  Mesh mesh = before;
  shapes::relax(mesh, onto_sphere, 20, {});
  CHECK(mesh.positions.size() == before.positions.size());
  CHECK(mesh.faces.size() == before.faces.size());
  CHECK(count(mesh).genera == std::vector<long>{0});
  CHECK(mean_smallest_angle(before) < 45);
  CHECK(mean_smallest_angle(mesh) > 54);
  for (const Vec3& point : mesh.positions) CHECK(point.norm() == doctest::Approx(1).epsilon(1e-14));
}

TEST_CASE("valences of a torus come back to six, but for a few where angles gain more") {
  const auto onto_torus = [](const Vec3& p) -> Vec3 {
    const Vec3 ring = Vec3(p.x(), p.y(), 0).normalized();
    return ring + 0.4 * (p - ring).normalized();
  };
  // A grid in which some squares are split along the other diagonal.
  Mesh mesh = torus(1, 0.4, 40, 16);
  for (std::size_t f = 10; f + 1 < mesh.faces.size(); f += 38) {
    const auto [a, b, c] = mesh.faces[f];
    const Index d = mesh.faces[f + 1][2];
    mesh.faces[f] = {a, b, d};
    mesh.faces[f + 1] = {b, c, d};
  }
  const auto irregular = [](const Mesh& m) {
    const auto valence = Halfedges(m).valence;
    return std::count_if(valence.begin(), valence.end(), [](std::size_t v) { return v != 6; });
  };
  REQUIRE(count(mesh).genera == std::vector<long>{1});
  const auto before = irregular(mesh);
  REQUIRE(before > 100);
  shapes::relax(mesh, onto_torus, 4, {});
  CHECK(4 * irregular(mesh) < before);
}

TEST_CASE("the result does not depend on the number of threads") {
  const auto relaxed = [](int threads) {
    const ThreadLimit limit(threads);
    Mesh mesh = shaken_sphere();
    shapes::relax(mesh, onto_sphere, 5, {});
    return mesh;
  };
  CHECK(relaxed(1).positions == relaxed(2).positions);
  CHECK(relaxed(1).faces == relaxed(4).faces);
}

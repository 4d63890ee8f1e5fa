#include "picture/ambient_occlusion.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "helpers/shapes.h"
#include "support/parallel.h"
#include "transformesh/control.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

std::vector<double> openness(Mesh mesh) {
  set_openness(mesh, "o");
  return mesh.vertex_columns.find("o")->values;
}

}  // namespace

TEST_CASE("convex bodies are open everywhere, the inside of a ball nowhere") {
  for (const Mesh& mesh : {icosphere(3), cuboid({0, 0, 0}, {1, 2, 3})})
    for (const double share : openness(mesh)) CHECK(share == 1);
  for (const double share : openness(reversed(icosphere(3)))) CHECK(share < 0.02);
}

TEST_CASE("the occlusion of a floor before a long wall agrees with the closed form") {
  // The wall at x = 0 is 1 high and 200 long. The form factor from a floor point at distance x to
  // the wall is (1 - x / sqrt(x^2 + 1)) / 2.
  Mesh mesh;
  mesh.positions = {{0, -100, 0}, {0, 100, 0}, {0, 100, 1}, {0, -100, 1}};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}};
  const std::vector<double> places{0.01, 0.3, 1, 3};
  for (const double x : places) {
    const auto first = static_cast<Index>(mesh.positions.size());
    for (const Vec3& corner : {Vec3(x, 0, 0), Vec3(x + 1e-3, 0, 0), Vec3(x, 1e-3, 0)})
      mesh.positions.push_back(corner);
    mesh.faces.push_back({first, first + 1, first + 2});
  }
  const std::vector<double> shares = openness(mesh);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double expected = 1 - (1 - places[i] / std::hypot(places[i], 1)) / 2;
    CHECK(std::abs(shares[4 + 3 * i] - expected) < 0.03);
  }
}

TEST_CASE("the hole of a torus is darker than its outside, alike all around") {
  const Mesh ring = torus(1, 0.6, 40, 24);
  const std::vector<double> shares = openness(ring);
  for (std::size_t v = 0; v < shares.size(); ++v) {
    const double radius = ring.positions[v].head<2>().norm();
    if (radius > 1.2) CHECK(shares[v] > 0.99);
    if (radius < 0.45) CHECK(shares[v] < 0.75);
    if (radius < 0.45) CHECK(shares[v] > 0.3);
  }
}

TEST_CASE("the same for any number of threads; what is degenerate is open") {
  const Mesh ring = torus(1, 0.6, 40, 24);
  const std::vector<double> all = openness(ring);
  const ThreadLimit one(1);
  CHECK(openness(ring) == all);
  Mesh flat;
  flat.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {7, 7, 7}};
  flat.faces = {{0, 1, 2}, {1, 1, 1}};
  for (const double share : openness(flat)) CHECK(share == 1);
}

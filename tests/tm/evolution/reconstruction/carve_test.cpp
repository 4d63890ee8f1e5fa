#include "tm/evolution/reconstruction/carve.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"

using namespace transformesh;

TEST_CASE("what photographs speak against is drawn inwards, and nothing else moves") {
  const Mesh ball = test::icosphere(4);
  std::vector<double> doubt;
  for (const Vec3& p : ball.positions) doubt.push_back(p.z() > 0.8 ? 0.5 : p.z() < -0.8 ? 1 : 0.1);
  Mesh mesh = ball;
  const double share = carve(mesh, doubt, 0.3);
  // A cap of a tenth of the sphere; what nobody sees is below.
  CHECK(share > 0.05);
  CHECK(share < 0.15);
  for (std::size_t v = 0; v < ball.positions.size(); ++v) {
    const double radius = mesh.positions[v].norm();
    if (ball.positions[v].z() > 0.97) CHECK(radius == doctest::Approx(0.7).epsilon(0.01));
    if (ball.positions[v].z() < 0.6) CHECK(mesh.positions[v] == ball.positions[v]);
    CHECK(radius < 1 + 1e-9);
  }
}

TEST_CASE("a surface without doubt, or with single doubtful vertices, stays") {
  const Mesh ball = test::icosphere(3);
  Mesh mesh = ball;
  std::vector<double> doubt(mesh.positions.size(), 0.19);
  CHECK(carve(mesh, doubt, 1) == 0);
  doubt[100] = 0.9;
  CHECK(carve(mesh, doubt, 1) == 0);
  CHECK(mesh.positions == ball.positions);
  Mesh empty;
  CHECK(carve(empty, {}, 1) == 0);
}

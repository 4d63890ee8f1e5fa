#include "shapes/implicit.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "helpers/mesh_facts.h"
#include "transformesh/errors.h"

using namespace transformesh;
using namespace transformesh::test;
using shapes::ImplicitSolid;

namespace {

ImplicitSolid ball(double radius) {
  ImplicitSolid solid;
  solid.function = [radius](const Vec3& p) { return p.norm() - radius; };
  return solid;
}

}  // namespace

TEST_CASE("the smooth minimum is the minimum where the two differ by the width, and less between") {
  CHECK(shapes::smooth_minimum(1, 2, 0.5) == 1);
  CHECK(shapes::smooth_minimum(2, 1, 1) == 1);
  CHECK(shapes::smooth_minimum(1, 1, 0.4) == doctest::Approx(0.9));      // a quarter of the width
  CHECK(shapes::smooth_minimum(1, 1.2, 0.4) == doctest::Approx(0.975));  // a sixteenth of it
  for (double a = 0; a < 1; a += 0.01) {
    const double step =
        shapes::smooth_minimum(a + 0.01, 0.5, 0.3) - shapes::smooth_minimum(a, 0.5, 0.3);
    CHECK(step >= 0);
    CHECK(step <= 0.01 + 1e-15);
  }
}

TEST_CASE("Newton steps lead to the foot on a sphere, and stay on the ray") {
  const Vec3 direction = Vec3(1, 2, 2) / 3;
  const Vec3 foot = shapes::projected(ball(1), 1.1 * direction, 6);
  CHECK((foot - direction).norm() < 1e-12);
  CHECK(shapes::projected(ball(1), direction, 6) == direction);
  // The gradient of an ellipsoid's quotient has another length, but the root is the same.
  ImplicitSolid flat;
  flat.function = [](const Vec3& p) { return 0.5 * (p.cwiseQuotient(Vec3(1, 1, 0.5)).norm() - 1); };
  CHECK(std::abs(flat.function(shapes::projected(flat, {0.6, 0.5, 0.3}, 8))) < 1e-12);
}

TEST_CASE(
    "the mesh of a ball has its vertices on the sphere, the faces wanted and good triangles") {
  const Mesh mesh = shapes::mesh_implicit(ball(0.9), 3000, {});
  CHECK(static_cast<double>(mesh.faces.size()) == doctest::Approx(3000).epsilon(0.05));
  for (const Vec3& point : mesh.positions)
    CHECK(point.norm() == doctest::Approx(0.9).epsilon(1e-12));
  CHECK(count(mesh).genera == std::vector<long>{0});
  CHECK(mean_smallest_angle(mesh) > 49);
}

TEST_CASE("a solid that takes more faces is refused with a number that is enough") {
  ImplicitSolid ring;
  ring.function = [](const Vec3& p) { return std::hypot(p.head<2>().norm() - 1, p.z()) - 0.05; };
  ring.genus = 1;
  std::string words;
  try {
    shapes::mesh_implicit(ring, 60, {});
  } catch (const UsageError& error) {
    words = error.what();
  }
  REQUIRE(words.find("60 faces are too few for this shape; ") == 0);
  const std::size_t enough = std::stoul(words.substr(words.find("; ") + 2));
  CHECK(count(shapes::mesh_implicit(ring, enough, {})).genera == std::vector<long>{1});
}

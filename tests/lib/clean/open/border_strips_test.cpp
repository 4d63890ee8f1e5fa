// Curves that end within rounding errors of a border.
#include "clean/open/border_strips.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "transformesh/clean.h"
#include "transformesh/measure.h"

using namespace transformesh;

namespace {

/// Half a cylinder of radius 1 around the line x = `x`, y = 0. Its ends are in the planes z = `z`
/// and z = `z` + 4.
Mesh arch(double x, double z) {
  constexpr double pi = 3.14159265358979323846;
  Mesh mesh = test::grid(16);
  for (Vec3& p : mesh.positions)
    p = {x + std::cos(pi * p.x()), std::sin(pi * p.x()), z + 4 * p.y()};
  return mesh;
}

Mesh rotated(Mesh mesh, test::Random& random) {
  const Vec3 axis = random.point(-1, 1).normalized();
  const Eigen::AngleAxisd rotation(random.uniform(0, 3), axis);
  for (Vec3& p : mesh.positions) p = rotation * p;
  return mesh;
}

}  // namespace

TEST_CASE("rounded borders in common planes do not keep the hidden parts of two arches") {
  test::Random random(5);
  const Mesh both = test::joined(arch(-0.5, 0), arch(0.5, 0));
  const double visible = surface_area(clean(both).mesh);
  CHECK(visible < 0.7 * surface_area(both));
  for (int round = 0; round < 40; ++round) {
    CAPTURE(round);
    const Mesh cleaned = clean(rotated(both, random)).mesh;
    CHECK(surface_area(cleaned) == doctest::Approx(visible).epsilon(1e-9));
  }
}

TEST_CASE("strips are found at tiny and huge scales") {
  test::Random random(6);
  const Mesh both = rotated(test::joined(arch(-0.5, 0), arch(0.5, 0)), random);
  const Mesh cleaned = clean(both).mesh;
  for (const int exponent : {-700, -560, 560, 700}) {
    CAPTURE(exponent);
    const double scale = std::ldexp(1.0, exponent);
    CHECK(clean(test::scaled(both, scale)).mesh.faces == cleaned.faces);
  }
}

TEST_CASE("a curve that ends away from the border separates nothing") {
  const Mesh both = test::joined(arch(-0.5, 0), arch(0.5, 1e-6));
  CHECK(surface_area(clean(both).mesh) == doctest::Approx(surface_area(both)));
}

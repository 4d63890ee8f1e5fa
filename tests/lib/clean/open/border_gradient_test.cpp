#include "clean/open/border_gradient.h"

#include <doctest/doctest.h>

#include <cmath>

#include "geometry/solid_angle_winding.h"
#include "helpers/random.h"
#include "helpers/shapes.h"

using namespace transformesh;

namespace {

/// A grid of unit size in the plane z = 0, with its center at the origin.
Mesh sheet() { return test::moved(test::grid(6), {-.5, -.5, 0}); }

}  // namespace

TEST_CASE("a closed mesh has no gradient, also at its surface") {
  const Mesh ball = test::icosphere(2);
  CHECK(BorderGradient(ball).in({Vec3::Constant(-2), Vec3::Constant(2)}) == 0);
}

TEST_CASE("a box that touches the border has no finite bound") {
  const BorderGradient gradient(sheet());
  CHECK(std::isinf(gradient.in({Vec3(.4, .4, -.1), Vec3(.6, .6, .1)})));
  CHECK(std::isfinite(gradient.in({Vec3(-.4, -.4, -.1), Vec3(.4, .4, .1)})));
}

TEST_CASE("winding numbers in a box differ by less than the bound allows") {
  const Mesh mesh = sheet();
  const BorderGradient gradient(mesh);
  const SolidAngleWinding winding(mesh);
  test::Random random(3);
  for (int round = 0; round < 300; ++round) {
    const double size = random.uniform(.01, .4);
    Vec3 low = random.point(-1, 1);
    low.z() = random.uniform(.02, 1);  // above the sheet, which is between no two points of the box
    const Vec3 from = low + size * random.point(0, 1), to = low + size * random.point(0, 1);
    const double bound = gradient.in({low, low + Vec3::Constant(size)});
    CHECK(std::abs(winding(from).number - winding(to).number) <= bound * (to - from).norm() + 1e-9);
  }
}

TEST_CASE("far from the border the bound is close to the integral over the border") {
  // The point is at the height h above the center of a square with sides of length 1. Its distance
  // from all points of the border is almost h. Hence the integral is 4 / h^2.
  const double h = 20;
  const double bound = BorderGradient(sheet()).in(Box(Vec3(0, 0, h)));
  const double integral = 4 / (h * h) / (4 * 3.14159265358979);
  CHECK(bound >= integral * (1 - 1e-2));
  CHECK(bound <= integral * 1.3);
}

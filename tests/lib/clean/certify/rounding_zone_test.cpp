/// Contact of rounding boxes with triangles, compared with points sampled on the triangles.
#include "clean/certify/rounding_zone.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "helpers/random.h"

using namespace transformesh;

namespace {

/// Returns the least distance of the point from sampled points of the triangle. The distance is the
/// largest difference along an axis, in multiples of the margin of that axis.
double sampled_distance(const Vec3& margins, const Vec3& point, const Triangle& t, int steps) {
  double least = 1e300;
  for (int i = 0; i <= steps; ++i)
    for (int k = 0; i + k <= steps; ++k) {
      const Vec3 on = t[0] + (i * (t[1] - t[0]) + k * (t[2] - t[0])) / steps;
      least = std::min(least, (on - point).cwiseQuotient(margins).cwiseAbs().maxCoeff());
    }
  return least;
}

}  // namespace

TEST_CASE("a point is within the margins of a triangle where its box meets the triangle") {
  test::Random random(7);
  int within = 0, apart = 0;
  for (int i = 0; i < 4000; ++i) {
    const Triangle t = {random.point(-3, 3), random.point(-3, 3), random.point(-3, 3)};
    const Vec3 margins = random.point(0.1, 1);
    const Vec3 point = random.point(-3, 3);
    constexpr int steps = 60;
    const double least = sampled_distance(margins, point, t, steps);
    const double spacing = std::max((t[1] - t[0]).cwiseQuotient(margins).lpNorm<Eigen::Infinity>(),
                                    (t[2] - t[0]).cwiseQuotient(margins).lpNorm<Eigen::Infinity>());
    if (least <= 1) {
      CHECK(is_within(margins, point, t));
      ++within;
    } else if (least > 1 + 2 * spacing / steps) {
      CHECK(!is_within(margins, point, t));
      ++apart;
    }
  }
  CHECK(within > 300);
  CHECK(apart > 300);
}

TEST_CASE("margins reach along each axis by themselves, not around the corner") {
  const Triangle t = {Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(0, 10, 0)};
  const Vec3 margins(1, 1, 0.01);
  CHECK(is_within(margins, Vec3(2, 2, 0.009), t));
  CHECK(!is_within(margins, Vec3(2, 2, 0.012), t));
  CHECK(is_within(margins, Vec3(-0.9, -0.9, 0), t));
  CHECK(!is_within(margins, Vec3(-1.1, 3, 0), t));
  CHECK(!is_within(margins, Vec3(6.1, 6.1, 0), t));  // beyond the longest edge
  CHECK(is_within(margins, Vec3(5.9, 5.9, 0), t));
}

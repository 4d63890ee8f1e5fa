/// Distances of points near the origin from triangles. Some corners are so far away that
/// differences of coordinates lose all digits of the points.
#include "clean/rounding/triangle_distance.h"

#include <doctest/doctest.h>

using namespace transformesh;

TEST_CASE("distances from a line are accurate near one end, however far the other is") {
  for (const double far : {10.0, 1e20, 1e100, 1e300}) {
    const Vec3 a(0, 0, 0), b(far, 0, 0), point(1, 3, 4);
    for (const LineDistance& d :
         {distance_from_line(a, b, point), distance_from_line(b, a, point)}) {
      CHECK(d.distance == doctest::Approx(5));
      CHECK(d.beyond == doctest::Approx(-1));
    }
    CHECK(distance_from_line(a, b, Vec3(-2, 1, 0)).beyond == doctest::Approx(2));
    CHECK(distance_from_line(b, a, Vec3(-2, 1, 0)).beyond == doctest::Approx(2));
  }
}

TEST_CASE("heights over a plane are accurate near a corner, however far the others are") {
  for (const double far : {10.0, 1e20, 1e100, 1e300}) {
    const Triangle t = {Vec3(far, 0, 0), Vec3(0, far, 0), Vec3(0, 0, 0)};
    const Vec3 normal = unit_normal(t);
    CHECK((normal - Vec3(0, 0, 1)).norm() == doctest::Approx(0));
    CHECK(height_over(t, normal, Vec3(0.5, 0.25, -3)) == doctest::Approx(-3));
  }
}

TEST_CASE("a sliver has the normal of its obtuse corner, and a line none") {
  const Triangle sliver = {Vec3(-1e100, 0, 0), Vec3(1e100, 0, 0), Vec3(0, 1, 0)};
  CHECK((unit_normal(sliver) - Vec3(0, 0, 1)).norm() == doctest::Approx(0));
  const Triangle line = {Vec3(0, 0, 0), Vec3(1, 2, 3), Vec3(2, 4, 6)};
  CHECK(unit_normal(line).isZero(0));
}

TEST_CASE("a relative height is that over the longest edge, as a share of it") {
  for (const double size : {1e-200, 1.0, 1e200}) {
    const Triangle t = {Vec3(0, 0, 0), Vec3(4 * size, 0, 0), Vec3(size, size, 0)};
    CHECK(relative_height(t) == doctest::Approx(0.25));
  }
  CHECK(relative_height({Vec3(1, 2, 3), Vec3(1, 2, 3), Vec3(1, 2, 3)}) == 0);
}

/// Distances beside corners so far away that differences with them lose everything near the origin.
#include "clean/rounding/local_distance.h"

#include <doctest/doctest.h>

namespace transformesh {

TEST_CASE("distances from a line are right near one of its ends, however far the other is") {
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

TEST_CASE("heights over a plane are right near a corner, however far the others are") {
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

TEST_CASE("the spacing along a direction is that of the axes along which it leads") {
  const Spacings spacings{Scalar::float64};
  const double at_one = 0x1p-52, far = 0x1p60;
  const Vec3 point(far, 1, 1.5);
  CHECK(spacings.along(Vec3(0, 1, 0), point) == at_one);
  CHECK(spacings.along(Vec3(1, 0, 0), point) == far * at_one);
  CHECK(spacings.along(Vec3(0.6, 0.8, 0), point) == far * at_one);
  // The plane y = 2^-60 x rises by a spacing at 1 where x does by that at 2^60.
  CHECK(spacings.along(Vec3(0x1p-60, 1, 0), point) == 1024 * at_one);
  CHECK(Spacings{Scalar::float64, false}.along(Vec3(0, 1, 0), point) == far * at_one);
  CHECK(Spacings{Scalar::float32}.along(Vec3(0, 1, 0), point) == 0x1p-23);
  CHECK(spacings.along(Vec3::Zero(), point) == far * at_one);
}

TEST_CASE("at a corner, the spacings that count follow the extent of the face") {
  const Spacings spacings{Scalar::float64};
  const double at_one = 0x1p-52, far = 0x1p60;
  const Vec3 corner(far, 1, 0);
  const Vec3 even = spacings.on_face(Vec3(1, 1, 1), corner);
  CHECK(even == Vec3::Constant(far * at_one));
  const Vec3 flat = spacings.on_face(Vec3(0x1p60, 1, 0), corner);
  CHECK(flat == Vec3(far * at_one, 1024 * at_one, spacing_around(Vec3::Zero(), Scalar::float64)));
  CHECK((Spacings{Scalar::float64, false}.on_face(Vec3(0x1p60, 1, 0), corner)) == even);
}

}  // namespace transformesh

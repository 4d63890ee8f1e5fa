#include "geometry/numbers/exact_point.h"

#include <doctest/doctest.h>

#include "helpers/rational.h"

using namespace transformesh;

using test::Rational;
using test::RationalPoint;

TEST_CASE("intersections of edges and weighted means agree with rationals") {
  const std::vector<Vec3> positions{{0, 0, 0}, {3, 1, 2}, {0, 1, 2}, {3, 0, 0}, {1e6, 1, 7}};
  const std::vector<Face> faces{{0, 1, 2}};
  const ExactGeometry geometry(positions, faces);
  const ExactPoint crossing = geometry.point(PointDefinition::line_line(0, 1, 2, 3));
  const ExactPoint middle = ExactGeometry::free({1.5, 0.5, 1});
  CHECK(geometry.compare(crossing, middle) == 0);
  CHECK(geometry.compare(geometry.point(PointDefinition::line_line(3, 2, 1, 0)), middle) == 0);

  // The point (2 a + 3 b + 5 c) / 10 of given points and of an intersection point.
  const ExactPoint mean = geometry.mean(geometry.given(4), crossing, geometry.given(3), {2, 3, 5});
  const RationalPoint truth{(2 * Rational(1e6) + 3 * Rational(1.5) + 5 * 3) / 10,
                            (2 + Rational(1.5)) / 10, Rational(14 + 3) / 10};
  for (int k = 0; k < 3; ++k) {
    CHECK(abs(truth[static_cast<std::size_t>(k)] - Rational(mean.center[k])) <=
          Rational(mean.radius[k]));
  }
  CHECK(geometry.compare_coordinate(mean, ExactGeometry::free({0, 0.35, 0}), 1) ==
        (Rational(35) / 100 > Rational(0.35) ? 1 : -1));
}

TEST_CASE("only a definition makes points the same: means and free points have none") {
  const std::vector<Vec3> positions{{0, 0, 0}, {3, 1, 2}, {0, 1, 2}, {3, 0, 0}, {1, 5, 7}};
  const std::vector<Face> faces{{0, 1, 2}, {1, 2, 3}, {2, 3, 4}};
  const ExactGeometry geometry(positions, faces);
  const ExactPoint a = geometry.given(0), b = geometry.given(1), c = geometry.given(2);
  CHECK(same_definition(geometry.point(PointDefinition::line_line(0, 1, 2, 3)),
                        geometry.point(PointDefinition::line_line(3, 2, 1, 0))));
  CHECK(same_definition(geometry.three_planes(0, 1, 2), geometry.three_planes(2, 0, 1)));
  CHECK(!same_definition(a, b));
  CHECK(same_definition(a, geometry.given(0)));

  const ExactPoint first = geometry.mean(a, b, c, {1, 2, 3});
  const ExactPoint second = geometry.mean(a, b, c, {3, 2, 1});
  CHECK(first.definition.kind == ExactPoint::Kind::mean);
  CHECK(geometry.compare(first, second) != 0);
  CHECK(!same_definition(first, second));
  CHECK(!same_definition(first, geometry.three_planes(0, 1, 2)));
  CHECK(!same_definition(ExactGeometry::free({1, 1, 1}), a));
  CHECK(!same_definition(ExactGeometry::free({1, 1, 1}), ExactGeometry::free({2, 2, 2})));
}

#include "views/wrap/scale_normalization.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

using namespace transformesh;

TEST_CASE("a size becomes one between 1 and 2, and comes back without rounding") {
  for (const double size : {1e-280, 3.7e-9, 1.0, 1.999, 2.0, 12345.678, 8e280}) {
    const ScaleNormalization scale(size);
    CHECK(scale.to_unit(size) >= 1);
    CHECK(scale.to_unit(size) <= 2);
    CHECK(scale.from_unit(scale.to_unit(size)) == size);
    Mesh mesh;
    mesh.positions = scale.to_unit(std::vector<Vec3>{Vec3(size, -size / 3, 0)});
    scale.from_unit(mesh);
    CHECK(mesh.positions[0] == Vec3(size, -size / 3, 0));
  }
}

TEST_CASE("sizes that no exponent brings to 1 are refused") {
  for (const double size : {0.0, 1e-300, 1e300, std::numeric_limits<double>::infinity(),
                            std::numeric_limits<double>::quiet_NaN()})
    CHECK_THROWS_AS(ScaleNormalization{size}, InputError);
}

TEST_CASE("the diagonal of points is that of their box, also where squares overflow") {
  CHECK(diagonal_of(std::vector<Vec3>{{1, 2, 3}, {4, 6, 3}}) == 5);
  CHECK(diagonal_of(std::vector<Vec3>{{0, 0, 0}, {3e200, 4e200, 0}}) == doctest::Approx(5e200));
}

TEST_CASE("each point names the first that is equal to it") {
  const std::vector<Vec3> points{{1, 0, 0}, {2, 0, 0},    {1, 0, 0},
                                 {1, 0, 0}, {-0.0, 0, 0}, {0, 0, 0}};
  CHECK(first_equals(points) == std::vector<std::size_t>{0, 1, 0, 0, 4, 4});
}

TEST_CASE("a detail below the spacing of the coordinates is refused") {
  const std::vector<Vec3> points{{1e6, 0, 0}, {1e6 + 1, 1, 1}};
  CHECK_NOTHROW(check_detail(points, 1e-3, 1));
  CHECK_THROWS_AS(check_detail(points, 1e-12, 1), InputError);
}

TEST_CASE("a wrap is turned outwards, and refused if it is open") {
  Mesh mesh = test::reversed(test::cube());
  check_wrap(mesh);
  CHECK(volume(mesh) == doctest::Approx(1));
  mesh.faces.pop_back();
  CHECK_THROWS_AS(check_wrap(mesh), GoalError);
}

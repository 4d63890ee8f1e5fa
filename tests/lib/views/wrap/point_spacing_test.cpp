#include "views/wrap/point_spacing.h"

#include <doctest/doctest.h>

#include <cmath>

#include "helpers/point_clouds.h"

using namespace transformesh;

TEST_CASE("the spacing of points on a sphere is the root of the area of each") {
  for (const int count : {200, 5000}) {
    const double side = std::sqrt(4 * 3.14159265 / count);
    CHECK(point_spacing(test::sphere_cloud(count).points) == doctest::Approx(side).epsilon(0.12));
  }
  CHECK(point_spacing(std::vector<Vec3>(6, Vec3(1, 2, 3))) == 0);
}

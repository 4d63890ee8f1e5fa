#include "transformesh/target.h"

#include <doctest/doctest.h>

#include <limits>

#include "geometry/search/closest_point.h"
#include "helpers/random.h"
#include "helpers/shapes.h"
#include "step/prepare_target.h"
#include "transformesh/errors.h"

using namespace transformesh;

namespace {

Mesh point_with_normal(const Vec3& normal) {
  Mesh mesh;
  mesh.positions = {{1, 2, 3}};
  set_normal_columns(mesh, {normal});
  return mesh;
}

}  // namespace

TEST_CASE("normals of points are normalized") {
  const Target target = make_target(point_with_normal({0, -3, 4}));
  CHECK_FALSE(target.is_mesh());
  CHECK((target.normals[0] - Vec3(0, -0.6, 0.8)).norm() < 1e-15);
  CHECK(make_target(point_with_normal({0, 0, 0})).normals[0] == Vec3::Zero());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(make_target(point_with_normal({0, nan, 0})), InputError);
}

TEST_CASE("vertices without faces are not part of a target") {
  Mesh mesh = test::cube();
  mesh.positions.emplace_back(100, 100, 100);
  CHECK(make_target(mesh).mesh.positions.size() == 8);
}

TEST_CASE("a soup as target equals its mesh, beside edges and corners as well") {
  const Target soup = make_target(test::soup_of(test::cube()));
  CHECK(soup.mesh.positions.size() == 8);
  const Mesh cube = test::cube();
  const ClosestPointQuery to_soup(soup.mesh), to_cube(cube);
  test::Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 point = random.point(-1, 2);
    CHECK(to_soup(point).signed_distance == doctest::Approx(to_cube(point).signed_distance));
  }
}

TEST_CASE("empty and inside-out targets are refused; open ones have no inside") {
  CHECK_THROWS_AS(make_target(Mesh()), InputError);
  CHECK_THROWS_WITH_AS(make_target(test::reversed(test::cube())), doctest::Contains("inside out"),
                       InputError);
  const Mesh open = test::reversed(test::grid(2));
  CHECK(make_target(open).is_mesh());
}

#include "transformesh/wrap.h"

#include <doctest/doctest.h>

#include "helpers/point_clouds.h"
#include "transformesh/errors.h"

using namespace transformesh;
using namespace transformesh::test;

TEST_CASE("scaling the points scales the wrap, up to where squares overflow or vanish") {
  const Cloud cloud = sphere_cloud(300, 0.02);
  const Mesh alpha = alpha_wrap(cloud.points).mesh;
  const Mesh poisson = poisson_wrap(cloud.points, cloud.normals);
  for (const double factor : {0x1p-950, 0x1p-600, 0x1p-300, 0x1p-7, 0x1p7, 0x1p520, 0x1p900}) {
    CAPTURE(factor);
    const std::vector<Vec3> points = scaled(cloud.points, factor);
    const AlphaWrap wrap = alpha_wrap(points);
    CHECK(wrap.mesh.positions == scaled(alpha.positions, factor));
    CHECK(wrap.mesh.faces == alpha.faces);
    CHECK(alpha_wrap(points, {.alpha = wrap.alpha}).mesh.positions == wrap.mesh.positions);
    CHECK(poisson_wrap(points, cloud.normals).positions == scaled(poisson.positions, factor));
  }
}

TEST_CASE("points too far apart, too close, or too far off for their size are refused") {
  const Cloud cloud = sphere_cloud(200);
  for (const double factor : {1e-320, 1e-300, 1e300, 1.7e308}) {
    CAPTURE(factor);
    const std::vector<Vec3> points = scaled(cloud.points, factor);
    CHECK_THROWS_WITH_AS(alpha_wrap(points), doctest::Contains("scale them"), InputError);
    CHECK_THROWS_WITH_AS(poisson_wrap(points, cloud.normals), doctest::Contains("scale them"),
                         InputError);
  }
  for (const double distance : {1e13, 1e30, 1e300}) {
    CAPTURE(distance);
    std::vector<Vec3> points = cloud.points;
    for (Vec3& point : points) point.x() += distance;
    CHECK_THROWS_WITH_AS(alpha_wrap(points), doctest::Contains("to the origin"), InputError);
  }
  CHECK_THROWS_AS(alpha_wrap(cloud.points, {.alpha = 1e300}), InputError);
  CHECK_THROWS_AS(alpha_wrap(cloud.points, {.alpha = 1e-300}), InputError);
  CHECK_THROWS_AS(alpha_wrap(cloud.points, {.offset = 1e-300}), InputError);
}

TEST_CASE("one point, two, and points on a line or in a plane, at any scale") {
  for (const double scale : {1e-300, 1e-154, 1.0, 1e154, 1e300}) {
    const std::vector<Vec3> one(3, Vec3(scale, scale, scale));
    const std::vector<Vec3> two = {{scale, 0, 0}, {0, scale, 0}};
    std::vector<Vec3> line, plane;
    for (int i = 0; i < 30; ++i) {
      line.emplace_back(scale * i, scale * i / 2, 0);
      plane.emplace_back(scale * (i % 6), scale * (i % 5), 0);
    }
    for (const std::vector<Vec3>& points : {one, two, line, plane}) {
      CAPTURE(scale);
      CAPTURE(points.size());
      const bool is_refused = scale == 1e-300 || scale == 1e300 || points[0] == points[1];
      if (is_refused) {
        CHECK_THROWS_AS(alpha_wrap(points), InputError);
      } else {
        CHECK(test::count(alpha_wrap(points).mesh).is_closed_and_oriented);
      }
      CHECK_THROWS_AS(poisson_wrap(points, std::vector<Vec3>(points.size(), Vec3::UnitZ())),
                      InputError);
    }
  }
}

TEST_CASE("the same bytes each time") {
  const Cloud cloud = sphere_cloud(300, 0.02);
  const Mesh first = poisson_wrap(cloud.points, cloud.normals);
  const Mesh second = poisson_wrap(cloud.points, cloud.normals);
  CHECK(first.positions == second.positions);
  CHECK(first.faces == second.faces);
  CHECK(alpha_wrap(cloud.points).mesh.positions == alpha_wrap(cloud.points).mesh.positions);
}

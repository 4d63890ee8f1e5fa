#include <doctest/doctest.h>

#include "geometry/search/closest_point.h"
#include "geometry/solid_angle_winding.h"
#include "helpers/point_clouds.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/wrap.h"

using namespace transformesh;
using namespace transformesh::test;

TEST_CASE("an alpha wrap contains all points, at its offset") {
  const Cloud cloud = sphere_cloud(800);
  const Mesh mesh = alpha_wrap(cloud.points, {.alpha = 0.2, .offset = 0.02}).mesh;
  check_surface(mesh);
  CHECK(connected_components(mesh).components.size() == 1);
  const SolidAngleWinding winding(mesh);
  for (const Vec3& point : cloud.points) CHECK(winding(point).rounded() == 1);
  for (const Vec3& position : mesh.positions) {
    CHECK(position.norm() > 0.95);
    CHECK(position.norm() < 1.03);
  }
}

// Each point is wrapped separately, by a tetrahedron or two.
TEST_CASE("vertices lie at the offset, and faces between them come nearer, by as much as is said") {
  std::vector<Vec3> points;
  for (int i = 0; i < 216; ++i) points.emplace_back(i % 6, i / 6 % 6, i / 36);
  for (const double alpha : {0.4, 3.0}) {
    const double offset = 0.1;
    const AlphaWrap wrap = alpha_wrap(points, {.alpha = alpha, .offset = offset});
    double least = 1e9;
    const SolidAngleWinding winding(wrap.mesh);
    for (const Vec3& point : points) {
      CHECK(winding(point).rounded() == 1);
      for (const Face& face : wrap.mesh.faces)
        least = std::min(least, (closest_point_of_triangle(point, wrap.mesh.positions[face[0]],
                                                           wrap.mesh.positions[face[1]],
                                                           wrap.mesh.positions[face[2]])
                                     .point -
                                 point)
                                    .norm());
    }
    CHECK(wrap.least_distance == doctest::Approx(least).epsilon(1e-9));
    CHECK(least > 0);
    CHECK(least < 0.9 * offset);
    for (const Vec3& position : wrap.mesh.positions) {
      double distance = 1e9;
      for (const Vec3& point : points) distance = std::min(distance, (point - position).norm());
      CHECK(distance > 0.99 * offset);
      CHECK(distance < 1.02 * offset);
    }
  }
}

TEST_CASE("alpha decides what is a hole") {
  // A small ball passes through the ring, a large one does not.
  const std::vector<Vec3> ring = ring_points(3000);
  const Mesh fine = alpha_wrap(ring, {.alpha = 0.25, .offset = 0.02}).mesh;
  check_surface(fine);
  CHECK(connected_components(fine).components[0].genus() == 1);
  const Mesh coarse = alpha_wrap(ring, {.alpha = 1.5, .offset = 0.02}).mesh;
  check_surface(coarse);
  CHECK(connected_components(coarse).components[0].genus() == 0);
}

TEST_CASE("the alpha that is found fits the points: tight, but not between them") {
  double before = 10;
  for (const int count : {200, 800, 3200, 12800}) {
    CAPTURE(count);
    const AlphaWrap ring = alpha_wrap(ring_points(count));
    check_surface(ring.mesh);
    REQUIRE(connected_components(ring.mesh).components.size() == 1);
    CHECK(connected_components(ring.mesh).components[0].genus() == 1);
    // Pappus: 2 pi^2 R r^2.
    CHECK(volume(ring.mesh) == doctest::Approx(1.7765).epsilon(0.15));
    CHECK(ring.alpha < before);
    before = ring.alpha;
  }
  CHECK(before < 0.15);
}

TEST_CASE("an alpha of millions of faces is refused before it takes its time") {
  const Cloud cloud = sphere_cloud(1000);
  for (const double alpha : {0.004, 1e-4, 1e-8}) {
    CAPTURE(alpha);
    CHECK_THROWS_WITH_AS(alpha_wrap(cloud.points, {.alpha = alpha, .offset = 0.1}),
                         doctest::Contains("too small"), UsageError);
  }
  // One ball; and many small ones, each separate.
  CHECK_THROWS_AS(alpha_wrap(std::vector<Vec3>{Vec3::Zero()}, {.alpha = 1e-4, .offset = 1}),
                  UsageError);
  check_surface(alpha_wrap(cloud.points, {.alpha = 1e-4, .offset = 1e-4}).mesh);
}

TEST_CASE("no points, one without lengths and senseless options are refused") {
  const std::vector<Vec3> none;
  CHECK_THROWS_AS(alpha_wrap(none), InputError);
  const std::vector<Vec3> one = {{1, 2, 3}};
  CHECK_THROWS_AS(alpha_wrap(one), InputError);
  check_surface(alpha_wrap(one, {.alpha = 0.2, .offset = 0.1}).mesh);
  CHECK_THROWS_AS(alpha_wrap(one, {.alpha = -1}), UsageError);
  CHECK_THROWS_AS(alpha_wrap(one, {.alpha = 1, .offset = -1}), UsageError);

  std::vector<Vec3> plane;
  for (int i = 0; i < 25; ++i) plane.emplace_back(i % 5, i / 5, 1);
  check_surface(alpha_wrap(plane, {.alpha = 2, .offset = 0.1}).mesh);
}

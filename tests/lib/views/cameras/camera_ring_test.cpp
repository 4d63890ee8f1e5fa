#include "views/cameras/camera_ring.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "transformesh/errors.h"

using namespace transformesh;

TEST_CASE("every camera looks at the center from its place, with z upwards in the image") {
  CameraRing ring;
  ring.count = 5;
  ring.center = {1, -2, 3};
  ring.distance = 7;
  const CameraList list = camera_ring(ring);
  REQUIRE(list.cameras.size() == 5);
  for (std::size_t i = 0; i < 5; ++i) {
    const PinholeCamera& camera = list.cameras[i].camera;
    const Vec3 back = (camera.center() - ring.center) / 7;
    CHECK(back.norm() == doctest::Approx(1));
    CHECK(std::asin(back.z()) * 180 / 3.14159265 == doctest::Approx(i % 2 == 0 ? 18 : -12));
    CHECK(
        std::remainder(std::atan2(back.y(), back.x()) - 2 * 3.14159265 / 5 * static_cast<double>(i),
                       2 * 3.14159265) == doctest::Approx(0).scale(1));
    CHECK(camera.rotation.determinant() == doctest::Approx(1));

    const auto pixel = [&](const Vec3& point) -> Eigen::Vector2d {
      return (camera.projection() * point.homogeneous()).hnormalized();
    };
    CHECK((pixel(ring.center) - Eigen::Vector2d(159.5, 119.5)).norm() < 1e-9);
    CHECK(pixel(ring.center + Vec3(0, 0, 0.1)).y() < 119);
    CHECK(list.cameras[i].width == 320);
  }
  CHECK(list.cameras[3].name == "view0003");
}

TEST_CASE("from the distance for some points all of them are in the image, near its border") {
  CameraRing ring;
  const std::vector<Vec3> points = {{0, 0, 2}, {0, 0, -2}, {1, 1, 0}};
  ring.distance = distance_for(points, ring);
  ring.elevations_deg = {0};
  const PinholeCamera camera = camera_ring(ring).cameras[0].camera;
  const Vec3 q = camera.projection() * points[0].homogeneous();
  CHECK(q.y() / q.z() > 2);
  CHECK(q.y() / q.z() < 20);
}

TEST_CASE("invalid rings are refused") {
  CHECK_THROWS_AS(camera_ring({.count = 0}), UsageError);
  CHECK_THROWS_AS(camera_ring({.elevations_deg = {}}), UsageError);
  CHECK_THROWS_AS(camera_ring({.elevations_deg = {90}}), UsageError);
  CHECK_THROWS_AS(camera_ring({.distance = 0}), UsageError);
  CHECK_THROWS_AS(camera_ring({.width = 0}), UsageError);
  CHECK_THROWS_AS(camera_ring({.focal_length = -1}), UsageError);
}

// Distances from depth maps of a plane, which are known in closed form.
#include "views/depth/depth_surface.h"

#include <doctest/doctest.h>

#include <cmath>

#include "helpers/view_maker.h"

using namespace transformesh;

namespace {

const view_maker::Frame frame{64, 48, 80};

/// Returns the depth map of the plane through the origin with this unit normal.
DepthMap map_of_plane(const PinholeCamera& camera, const Vec3& normal) {
  DepthMap map{GrayImage(frame.width, frame.height), 0.01};
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x)
      map.depth.at(x, y) =
          static_cast<float>(-normal.dot(camera.center()) / normal.dot(camera.ray(x, y)));
  return map;
}

}  // namespace

TEST_CASE("distances from a slanted plane are those along its normal, with the cosine of the ray") {
  const PinholeCamera camera = view_maker::camera_at(Vec3(0, -3, 3), frame);
  const Vec3 normal = Vec3::UnitZ();
  const DepthSurface surface(camera, map_of_plane(camera, normal), 1);
  for (const double height : {-0.1, 0.0, 0.05, 0.3}) {
    const Vec3 point(0.21, 0.13, height);
    const auto found = surface.distance_of(point);
    REQUIRE(found);
    CHECK(found->distance == doctest::Approx(height).epsilon(0.01).scale(0.1));
    CHECK(found->cosine ==
          doctest::Approx((camera.center() - point).normalized().dot(normal)).epsilon(0.02));
  }
  CHECK(std::abs(surface.point_of(20, 30).z()) < 1e-5);
}

TEST_CASE("points outside of the image, behind the camera and at unknown depths have no distance") {
  const PinholeCamera camera = view_maker::camera_at(Vec3(0, -3, 3), frame);
  DepthMap map = map_of_plane(camera, Vec3::UnitZ());
  map.depth.at(32, 24) = 0;
  const DepthSurface surface(camera, map, 1);
  CHECK_FALSE(surface.distance_of(camera.center() + camera.ray(32, 24)));
  CHECK(surface.distance_of(camera.center() + camera.ray(30, 24)));
  CHECK_FALSE(surface.distance_of(camera.center() - camera.ray(30, 24)));
  CHECK_FALSE(surface.distance_of(camera.center() + camera.ray(-3, 24)));
  CHECK_FALSE(surface.distance_of(camera.center() + camera.ray(30, 60)));
}

TEST_CASE("a step between two depths is not interpolated") {
  const PinholeCamera camera = view_maker::camera_at(Vec3(0, 0, 4), frame);
  DepthMap map{GrayImage(frame.width, frame.height, 4.0F), 0.01};
  for (int y = 0; y < frame.height; ++y)
    for (int x = 32; x < frame.width; ++x) map.depth.at(x, y) = 3;
  const DepthSurface surface(camera, map, 1);
  const auto left = surface.distance_of(camera.center() + 2 * camera.ray(31.3, 20));
  const auto right = surface.distance_of(camera.center() + 2 * camera.ray(31.7, 20));
  REQUIRE(left);
  REQUIRE(right);
  CHECK(left->distance == doctest::Approx(2));
  CHECK(right->distance == doctest::Approx(1));
}

#include "transformesh/pinhole_camera.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include "helpers/random.h"
#include "transformesh/errors.h"

using namespace transformesh;

namespace {

PinholeCamera some_camera() {
  PinholeCamera camera;
  camera.intrinsics << 300, 0.5, 160, 0, 310, 120, 0, 0, 1;
  camera.rotation = Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  camera.translation = {0.2, -0.4, 5};
  return camera;
}

Eigen::Vector2d pixel(const PinholeCamera& camera, const Vec3& point) {
  return (camera.projection() * point.homogeneous()).hnormalized();
}

/// A camera at `eye` whose axis goes through `target`.
PinholeCamera looking(const Vec3& eye, const Vec3& target, double focal) {
  const Vec3 axis = (target - eye).normalized();
  PinholeCamera camera;
  camera.rotation = Eigen::Quaterniond::FromTwoVectors(axis, Vec3::UnitZ()).toRotationMatrix();
  camera.translation = -(camera.rotation * eye);
  camera.intrinsics.diagonal() = Vec3(focal, focal, 1);
  return camera;
}

}  // namespace

TEST_CASE("a point lies on the ray of its pixel at its depth") {
  const PinholeCamera camera = some_camera();
  const Vec3 point(0.3, 0.1, -0.2);
  const Vec3 q = camera.projection() * point.homogeneous();
  const Eigen::Vector2d x = q.hnormalized();
  CHECK((camera.center() + q.z() * camera.ray(x.x(), x.y()) - point).norm() < 1e-12);
}

TEST_CASE("the corners of an image stay its corners when it shrinks") {
  const PinholeCamera camera = some_camera();
  const PinholeCamera small = camera.shrunk(2.5);
  for (const Vec3& point : {Vec3(0.3, 0.1, -0.2), Vec3(-0.5, 0.2, 0.4)}) {
    const Eigen::Vector2d corner = pixel(camera, point).array() + 0.5;
    const Eigen::Vector2d small_corner = pixel(small, point).array() + 0.5;
    CHECK((corner / 2.5 - small_corner).norm() < 1e-12);
  }
}

TEST_CASE("axes that meet in a point find it") {
  test::Random random(1);
  const Vec3 target(3, -4, 5);
  std::vector<PinholeCamera> cameras;
  for (int i = 0; i < 5; ++i) {
    cameras.push_back(looking(target + 9 * random.point(-1, 1), target, 100));
  }
  CHECK((viewed_point(cameras) - target).norm() < 1e-10);
}

TEST_CASE("two axes that pass each other: the middle of their shortest connection") {
  const std::vector<PinholeCamera> cameras{looking({-7, 0, 1}, {0, 0, 1}, 100),
                                           looking({0, 4, -1}, {0, 0, -1}, 100)};
  CHECK(viewed_point(cameras).norm() < 1e-12);
}

TEST_CASE("parallel axes: beside the mean of the centers") {
  const std::vector<PinholeCamera> cameras{looking({0, 0, 0}, {0, 0, 1}, 100),
                                           looking({2, 0, 4}, {2, 0, 5}, 100)};
  CHECK((viewed_point(cameras) - Vec3(1, 0, 2)).norm() < 1e-9);
}

TEST_CASE("the pixel size is the median of depth / focal length over views of the point") {
  const Vec3 point(0, 0, 0);
  std::vector<PinholeCamera> cameras{looking({0, 0, -6}, point, 300),
                                     looking({4, 0, 0}, point, 100),
                                     looking({0, 0, -1}, {0, 0, -2}, 1)};
  CHECK(pixel_size(cameras, point) == doctest::Approx((0.02 + 0.04) / 2));
  cameras.push_back(looking({0, 9, 0}, point, 10));
  CHECK(pixel_size(cameras, point) == doctest::Approx(0.04));
  CHECK_THROWS_AS(pixel_size(std::span(cameras).subspan(2, 1), point), InputError);
}

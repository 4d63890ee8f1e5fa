#include "tm/views/cameras/pinhole_camera.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

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

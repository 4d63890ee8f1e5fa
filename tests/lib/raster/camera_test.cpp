#include "raster/camera.h"

#include <doctest/doctest.h>

#include <cmath>

#include "helpers/random.h"
#include "helpers/shapes.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

Eigen::Vector2d pixel(const Camera& camera, const Vec3& point) {
  const Vec3 q = camera.project(point);
  return q.head<2>() / q.z();
}

constexpr double sine_of_half_view = 0.25881904510252074;  // 15 degrees

}  // namespace

TEST_CASE("a camera in front sees x to the right, y upwards and depth along its axis") {
  const Camera camera = orbit_camera({Vec3(1, 2, 3), 10}, {0, 0, Axis::y, 1}, 101, 61);
  CHECK((pixel(camera, {1, 2, 3}) - Eigen::Vector2d(50, 30)).norm() < 1e-12);
  CHECK(pixel(camera, {2, 2, 3}).x() > 50);
  CHECK(pixel(camera, {1, 3, 3}).y() < 30);
  CHECK(std::abs(camera.project({1, 2, 3}).z() - 10) < 1e-12);
  CHECK(std::abs(camera.project({5, -2, 6}).z() - 7) < 1e-12);
  CHECK((camera.center() - Vec3(1, 2, 13)).norm() < 1e-12);
  // The shorter side spans 30 degrees: 30.5 pixels at 15 degrees.
  const double half = 10 * std::tan(15 * 3.14159265358979323846 / 180);
  CHECK(std::abs(pixel(camera, {1, 2 + half, 3}).y() - (30 - 30.5)) < 1e-12);
}

TEST_CASE("azimuth moves the eye to its right and elevation upwards, whatever is up") {
  for (const Axis up : {Axis::x, Axis::y, Axis::z}) {
    const EyeAxes front = eye_axes({0, 0, up, 1});
    CHECK(front.up[static_cast<int>(up)] == 1);
    CHECK((front.right.cross(front.up) - front.back).norm() < 1e-15);
    CHECK((eye_axes({90, 0, up, 1}).back - front.right).norm() < 1e-15);
    CHECK((eye_axes({0, 90, up, 1}).back - front.up).norm() < 1e-15);
    CHECK((eye_axes({0, 90, up, 1}).right - front.right).norm() < 1e-15);
    const EyeAxes any = eye_axes({33, -71, up, 1});
    CHECK((any.right.cross(any.up) - any.back).norm() < 1e-15);
    CHECK(std::abs(any.right.dot(front.up)) < 1e-15);
  }
  CHECK((eye_axes({0, 0, Axis::z, 1}).back + Vec3::UnitY()).norm() == 0);
}

TEST_CASE("an aim fits the points tightly into the image, in the middle") {
  Random random(3);
  for (int round = 0; round < 20; ++round) {
    std::vector<Vec3> points(50);
    for (Vec3& point : points) point = random.point(-3, 5);
    const Orbit orbit{random.uniform(-180, 180), random.uniform(-90, 90), Axis::z, 1};
    const Camera camera = orbit_camera(aim_at(points, orbit, 300, 200), orbit, 300, 200);
    Eigen::Array2d low(1e9, 1e9);
    Eigen::Array2d high(-1e9, -1e9);
    for (const Vec3& point : points) {
      REQUIRE(camera.project(point).z() > 0);
      low = low.min(pixel(camera, point).array());
      high = high.max(pixel(camera, point).array());
    }
    // 4 % of the image is free on each side; one direction is filled.
    const Eigen::Array2d free(0.04 * 300 - 0.5, 0.04 * 200 - 0.5);
    const Eigen::Array2d beyond(299 - free.x(), 199 - free.y());
    CHECK((low >= free - 1e-9).all());
    CHECK((high <= beyond + 1e-9).all());
    const bool fills_width = low.x() < free.x() + 1e-9 && high.x() > beyond.x() - 1e-9;
    const bool fills_height = low.y() < free.y() + 1e-9 && high.y() > beyond.y() - 1e-9;
    CHECK((fills_width || fills_height));
  }
}

TEST_CASE("an aim at a sphere touches it with the field of view") {
  const Mesh ball = icosphere(5);
  const Aim aim = aim_at(ball.positions, {}, 400, 400);
  const double slope = 0.92 * std::tan(std::asin(sine_of_half_view));
  CHECK(std::abs(aim.distance - 1 / std::sin(std::atan(slope))) < 1e-3);
  CHECK(aim.target.norm() < 2e-3);
}

TEST_CASE("an aim at one place stays finite") {
  const std::vector<Vec3> points(3, Vec3(4, 5, 6));
  const Aim aim = aim_at(points, {}, 100, 100);
  CHECK(aim.distance == 1);
  CHECK((aim.target - points[0]).norm() < 1e-12);
}

TEST_CASE("a resampled camera keeps the outline of each pixel") {
  const Camera camera = orbit_camera({Vec3::Zero(), 5}, {}, 40, 30);
  const Camera fine = camera.resampled(3);
  CHECK(fine.width == 120);
  CHECK(fine.height == 90);
  const Vec3 point(0.3, 0.2, -0.4);
  // The left border of pixel x is at x - 1/2.
  const Eigen::Array2d coarse_place = pixel(camera, point).array() + 0.5;
  const Eigen::Array2d fine_place = pixel(fine, point).array() + 0.5;
  CHECK((3 * coarse_place - fine_place).abs().maxCoeff() < 1e-12);
  CHECK((fine.center() - camera.center()).norm() < 1e-12);
}

TEST_CASE("an aim of a turn fits the points at every azimuth, and tightly at one") {
  Random random(4);
  for (int round = 0; round < 20; ++round) {
    std::vector<Vec3> points(30);
    for (Vec3& point : points) point = random.point(-3, 5);
    Orbit orbit{0, random.uniform(-90, 90), Axis::z, 1};
    const Aim aim = turn_aim(points, orbit, 300, 200);
    double farthest = 0;  // distance from the middle, as a fraction of half a side
    for (orbit.azimuth_deg = 0; orbit.azimuth_deg < 360; ++orbit.azimuth_deg) {
      const Camera camera = orbit_camera(aim, orbit, 300, 200);
      for (const Vec3& point : points) {
        const Eigen::Vector2d place = pixel(camera, point);
        farthest = std::max(
            {farthest, std::abs(place.x() - 149.5) / 150, std::abs(place.y() - 99.5) / 100});
      }
    }
    CHECK(farthest < 0.92 + 1e-9);
    CHECK(farthest > 0.919);
  }
  CHECK(turn_aim(std::vector<Vec3>{Vec3::Zero()}, {}, 10, 10).distance == 1);
}

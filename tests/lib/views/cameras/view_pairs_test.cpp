#include "views/cameras/view_pairs.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

using namespace transformesh;

namespace {

PinholeCamera camera_at(const Vec3& center) {
  PinholeCamera camera;
  camera.translation = -center;
  return camera;
}

// Cameras on a circle around a point, `step` degrees apart.
std::vector<PinholeCamera> ring(double step_deg, const Vec3& middle) {
  std::vector<PinholeCamera> cameras;
  for (int i = 0; i * step_deg < 360 - 1e-6; ++i) {
    const double angle = i * step_deg * std::numbers::pi / 180;
    cameras.push_back(camera_at(middle + 3 * Vec3(std::cos(angle), std::sin(angle), 0)));
  }
  return cameras;
}

// Returns the steps around the ring to the partners of view i, sorted.
std::vector<long> steps(const std::vector<ViewPair>& pairs, std::size_t i, std::size_t count) {
  std::vector<long> found;
  for (const ViewPair& pair : pairs) {
    const auto n = static_cast<long>(count);
    const long step = (static_cast<long>(pair.second) - static_cast<long>(i) + n + n / 2) % n;
    if (pair.first == i) found.push_back(step - n / 2);
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<long> steps_in_ring(double step_deg, const PairOptions& options = {}) {
  const Vec3 middle(5, -2, 1);
  const auto cameras = ring(step_deg, middle);
  const auto pairs = choose_pairs(cameras, middle, options);
  const auto first = steps(pairs, 0, cameras.size());
  for (std::size_t i = 1; i < cameras.size(); ++i) {
    CHECK(steps(pairs, i, cameras.size()) == first);
  }
  return first;
}

}  // namespace

TEST_CASE("a sparse ring compares the nearest views") {
  CHECK(steps_in_ring(22.5) == std::vector<long>{-2, -1, 1, 2});
  CHECK(steps_in_ring(24) == std::vector<long>{-2, -1, 1, 2});
  PairOptions two;
  two.neighbors = 2;
  CHECK(steps_in_ring(22.5, two) == std::vector<long>{-1, 1});
}

TEST_CASE("a dense ring compares views that are far enough apart") {
  CHECK(steps_in_ring(7.5) == std::vector<long>{-3, -2, 2, 3});
  CHECK(steps_in_ring(5) == std::vector<long>{-4, -3, 3, 4});
  CHECK(steps_in_ring(1, {.neighbors = 2}) == std::vector<long>{-15, 15});
}

TEST_CASE("angles outside the limits make no pair") {
  CHECK(steps_in_ring(60).empty());
  CHECK(steps_in_ring(3, {.neighbors = 99, .minimum_angle_deg = 4, .maximum_angle_deg = 10}) ==
        std::vector<long>{-3, -2, 2, 3});
}

TEST_CASE("neighbors much farther than the best one may be left out, but not near ones") {
  CHECK(steps_in_ring(24) == std::vector<long>{-2, -1, 1, 2});
  CHECK(steps_in_ring(24, {.spread = 1.5}) == std::vector<long>{-1, 1});
  CHECK(steps_in_ring(24, {.spread = 2.1}) == std::vector<long>{-2, -1, 1, 2});
  CHECK(steps_in_ring(14, {.spread = 1}) == std::vector<long>{-2, -1, 1, 2});
  CHECK(steps_in_ring(45, {.spread = 1.1}) == std::vector<long>{-1, 1});
}

TEST_CASE("angles are those at the center, whatever the distances") {
  const Vec3 middle(1, 2, 3);
  const double angle = 0.3;
  const std::vector<PinholeCamera> cameras{
      camera_at(middle + 2 * Vec3(1, 0, 0)),
      camera_at(middle + 50 * Vec3(std::cos(angle), 0, std::sin(angle)))};
  const auto pairs = choose_pairs(cameras, middle);
  REQUIRE(pairs.size() == 2);
  CHECK(pairs[0].first == 0);
  CHECK(pairs[0].second == 1);
  CHECK(pairs[1].first == 1);
  CHECK(pairs[1].second == 0);
  CHECK(pairs[0].angle_deg == doctest::Approx(angle * 180 / std::numbers::pi).epsilon(1e-12));
}

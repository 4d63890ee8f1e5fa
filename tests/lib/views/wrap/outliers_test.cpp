/// Outliers that are strewn around clouds, and clouds of every sampling that have none.
#include "views/wrap/outliers.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "helpers/point_clouds.h"
#include "helpers/random.h"
#include "support/parallel.h"
#include "transformesh/control.h"

namespace transformesh {
namespace {

Vec3 direction(test::Random& random) {
  for (;;) {
    const Vec3 point = random.point(-1, 1);
    if (point.norm() > 0.1 && point.norm() < 1) return point.normalized();
  }
}

/// On a sphere, the share of points that is kept falling with z.
template <typename Share>
std::vector<Vec3> sphere_with(int count, std::uint64_t seed, const Share& share) {
  test::Random random(seed);
  std::vector<Vec3> points;
  while (static_cast<int>(points.size()) < count) {
    const Vec3 point = direction(random);
    if (random.uniform(0, 1) < share(point.z())) points.push_back(point);
  }
  return points;
}

/// Rays of a scanner at the origin, a unit above a plane.
std::vector<Vec3> scanned_plane(int count, std::uint64_t seed) {
  test::Random random(seed);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const double angle = random.uniform(0, 6.2831853),
                 reach = 1 / std::tan(random.uniform(0.02, 1.5));
    points.emplace_back(reach * std::cos(angle), reach * std::sin(angle), -1);
  }
  return points;
}

/// The definition, over all pairs.
std::vector<Index> by_brute_force(const std::vector<Vec3>& points) {
  std::vector<double> sixth;
  for (const Vec3& point : points) {
    std::vector<double> distances;
    for (const Vec3& other : points) distances.push_back((other - point).norm());
    std::ranges::nth_element(distances, distances.begin() + 6);
    sixth.push_back(distances[6]);
  }
  std::vector<double> sorted = sixth;
  std::ranges::sort(sorted, std::ranges::greater());
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < points.size() / 20; ++i)
    if (sorted[i] >= 4 * sorted[i + 1]) least = sorted[i];
  std::vector<Index> outliers;
  for (Index i = 0; i < points.size(); ++i)
    if (sixth[i] >= least) outliers.push_back(i);
  return outliers;
}

}  // namespace

TEST_CASE("outliers are found, near and far, alone and a few together") {
  for (const int count : {100, 1500, 20000})
    for (const double distance : {4.0, 30.0, 1e6}) {
      std::vector<Vec3> points = test::sphere_cloud(count, 0.02).points;
      test::Random random(7);
      std::vector<Index> expected;
      for (const int group : {1, 2, 2}) {
        const Vec3 middle = distance * direction(random);
        for (int i = 0; i < group; ++i) {
          expected.push_back(static_cast<Index>(points.size()));
          points.push_back(middle + 0.01 * direction(random));
        }
      }
      CAPTURE(count);
      CAPTURE(distance);
      CHECK(find_outliers(points) == expected);
      if (count < 2000) CHECK(by_brute_force(points) == expected);
      for (const double scale : {0x1p-500, 0x1p400})
        CHECK(find_outliers(test::scaled(points, scale)) == expected);
      const ThreadLimit limit(1);
      CHECK(find_outliers(points) == expected);
    }
}

TEST_CASE("no point of a clean cloud is an outlier, even if it is uneven") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (const int count : {40, 300, 3000}) {
      CAPTURE(seed);
      CAPTURE(count);
      CHECK(find_outliers(sphere_with(count, seed, [](double) { return 1; })).empty());
      // The density falls by 1000 from pole to pole, or jumps by 30 at the equator.
      CHECK(find_outliers(sphere_with(count, seed, [](double z) {
              return std::pow(1000, -(z + 1) / 2);
            })).empty());
      CHECK(find_outliers(sphere_with(count, seed, [](double z) {
              return z < 0 ? 1 : 0.03;
            })).empty());
      CHECK(find_outliers(scanned_plane(count, seed)).empty());
      CHECK(find_outliers(test::ring_points(count)).empty());
    }
  // Two bodies; a grid; copies of one point.
  std::vector<Vec3> points = test::sphere_cloud(500).points;
  for (const Vec3& point : test::sphere_cloud(50).points) points.push_back(point + Vec3(40, 0, 0));
  CHECK(find_outliers(points).empty());
  points.clear();
  for (int i = 0; i < 216; ++i) points.emplace_back(i % 6, i / 6 % 6, i / 36);
  CHECK(find_outliers(points).empty());
  points.assign(1000, Vec3(1, 2, 3));
  CHECK(find_outliers(points).empty());
  CHECK(find_outliers({}).empty());
}

TEST_CASE("equal points count once: a heap of outliers is one") {
  std::vector<Vec3> points = test::sphere_cloud(500).points;
  for (int i = 0; i < 5000; ++i) points.emplace_back(9, 9, 9);
  const std::vector<Index> outliers = find_outliers(points);
  CHECK(outliers.size() == 5000);
  CHECK(outliers.front() == 500);
}

}  // namespace transformesh

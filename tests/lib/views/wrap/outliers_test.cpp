/// Outliers around point clouds, and clouds of every kind of sampling without outliers.
#include "views/wrap/outliers.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "helpers/point_clouds.h"
#include "helpers/random.h"
#include "support/parallel.h"
#include "transformesh/control.h"

using namespace transformesh;

namespace {

Vec3 direction(test::Random& random) {
  for (;;) {
    const Vec3 point = random.point(-1, 1);
    if (point.norm() > 0.1 && point.norm() < 1) return point.normalized();
  }
}

/// Random points on a sphere; `share(z)` is the probability that a point is kept.
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

/// Points where rays of a scanner at the origin, one unit above a plane, meet the plane.
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

/// Returns the outliers by their definition, over all pairs of points.
std::vector<Index> by_brute_force(const std::vector<Vec3>& points) {
  const std::size_t count = points.size();
  const auto distance = [&](std::size_t i, std::size_t j) {
    return (points[i] - points[j]).norm();
  };
  std::vector<double> spacing;
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<double> distances;
    for (std::size_t j = 0; j < count; ++j) distances.push_back(distance(i, j));
    std::ranges::nth_element(distances, distances.begin() + 6);
    spacing.push_back(distances[6]);
  }
  const auto is_joined = [&](std::size_t i, std::size_t j) {
    const double length = distance(i, j);
    const bool are_neighbors = length <= spacing[i] || length <= spacing[j];
    return are_neighbors && length <= 2 * std::min(spacing[i], spacing[j]);
  };
  // Spreads the least index of each group to all of its points.
  std::vector<std::size_t> group(count);
  for (std::size_t i = 0; i < count; ++i) group[i] = i;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < count; ++j)
        if (group[j] < group[i] && is_joined(i, j)) group[i] = group[j], changed = true;
  }
  std::vector<std::size_t> sizes(count);
  for (const std::size_t g : group) ++sizes[g];
  std::vector<Index> outliers;
  for (std::size_t i = 0; i < count; ++i) {
    if (20 * sizes[group[i]] >= count) continue;
    std::size_t nearest = count;
    for (std::size_t j = 0; j < count; ++j)
      if (20 * sizes[group[j]] >= count &&
          (nearest == count || distance(i, j) < distance(i, nearest)))
        nearest = j;
    if (nearest < count && spacing[i] >= 4 * spacing[nearest])
      outliers.push_back(static_cast<Index>(i));
  }
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

TEST_CASE("no point of an even cloud is an outlier, and of uneven ones hardly any") {
  int touched = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (const int count : {40, 300, 3000}) {
      CAPTURE(seed);
      CAPTURE(count);
      CHECK(find_outliers(sphere_with(count, seed, [](double) { return 1; })).empty());
      // The density falls by 1000 from pole to pole, or jumps by 30 at the equator.
      CHECK(find_outliers(sphere_with(count, seed, [](double z) {
              return std::pow(1000, -(z + 1) / 2);
            })).empty());
      const auto sparse = sphere_with(count, seed, [](double z) { return z < 0 ? 1 : 0.03; });
      const std::size_t taken = find_outliers(sparse).size();
      CHECK(100 * taken <= static_cast<std::size_t>(count));
      touched += taken > 0 ? 1 : 0;
      // The distant points of a scan are few and sparse.
      const auto lost = find_outliers(scanned_plane(count, seed)).size();
      CHECK(100 * lost <= static_cast<std::size_t>(count));
      CHECK(find_outliers(test::ring_points(count)).empty());
    }
  constexpr int most_touched = 3;  // out of 60 clouds
  CHECK(touched <= most_touched);
  // Two bodies, a grid, and copies of one point have no outliers.
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

TEST_CASE("5 % of outliers far around a body are found, and most of 1 % near it") {
  struct Case {
    double size;
    int count, outliers, least;
  };
  for (const Case& c : {Case{10, 500, 25, 24}, Case{10, 5000, 250, 245}, Case{1000, 5000, 250, 250},
                        Case{2, 5000, 50, 40}}) {
    std::vector<Vec3> points = test::sphere_cloud(c.count, 0.005).points;
    test::Random random(5);
    for (int i = 0; i < c.outliers; ++i) points.push_back(random.point(-c.size, c.size));
    const std::vector<Index> outliers = find_outliers(points);
    CAPTURE(c.size);
    CAPTURE(c.count);
    // No point of the sphere is removed.
    CHECK((outliers.empty() || outliers.front() >= static_cast<Index>(c.count)));
    CHECK(static_cast<int>(outliers.size()) >= c.least);
    if (c.count == 500) CHECK(outliers == by_brute_force(points));
  }
}

TEST_CASE("equal points count once: a heap of outliers is one") {
  std::vector<Vec3> points = test::sphere_cloud(500).points;
  for (int i = 0; i < 5000; ++i) points.emplace_back(9, 9, 9);
  const std::vector<Index> outliers = find_outliers(points);
  CHECK(outliers.size() == 5000);
  CHECK(outliers.front() == 500);
}

/// Clusters: found however wide they are, told from fine meshes and from what lies about them.
#include "tm/clean/rounding/clusters.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "helpers/random.h"
#include "helpers/shapes.h"

namespace transformesh {
namespace {

constexpr double spacing = 0x1p-20;

/// Of that extent along x, y and z, about a point.
std::vector<Vec3> points_about(const Vec3& middle, double extent, std::size_t count) {
  test::Random random(count);
  std::vector<Vec3> points = {middle - Vec3::Constant(extent / 2),
                              middle + Vec3::Constant(extent / 2)};
  while (points.size() < count) points.push_back(middle + random.point(-extent / 2, extent / 2));
  return points;
}

/// By brute force: whether all are nearer to each other, along each axis, than to any other.
bool is_told_apart(const std::vector<Vec3>& points, const std::vector<Index>& cluster) {
  const auto distance = [&](Index i, Index k) {
    return (points[i] - points[k]).cwiseAbs().maxCoeff();
  };
  double extent = 0, gap = 1e300;
  for (const Index i : cluster) {
    for (Index k = 0; k < points.size(); ++k) {
      if (std::binary_search(cluster.begin(), cluster.end(), k))
        extent = std::max(extent, distance(i, k));
      else
        gap = std::min(gap, distance(i, k));
    }
  }
  return extent < gap;
}

}  // namespace

TEST_CASE(
    "a cluster is found whatever its extent and place, and what lies far from it is not in it") {
  for (const double extent : {1.0, 5.0, 40.0, 300.0, 2000.0}) {
    for (const Vec3& middle : {Vec3(0, 0, 0), Vec3(0.3, -0.7, 0.9), Vec3(-0.5, 0.25, 0)}) {
      CAPTURE(extent);
      const std::size_t count = 200 + static_cast<std::size_t>(extent);
      std::vector<Vec3> points = points_about(middle, extent * spacing, count);
      for (const Vec3& p : points_about(middle, 1, 100))
        if ((p - middle).norm() > 0.1) points.push_back(p);
      const std::vector<std::vector<Index>> clusters = find_clusters(points, spacing);
      REQUIRE(clusters.size() == 1);
      CHECK(clusters[0].size() == count);
      CHECK(clusters[0].back() == count - 1);
      CHECK(is_told_apart(points, clusters[0]));
    }
  }
}

TEST_CASE("fewer than thirty, or wider than the widest, is no cluster") {
  CHECK(find_clusters(points_about(Vec3(0, 0, 0), 4 * spacing, 29), spacing).empty());
  CHECK(find_clusters(points_about(Vec3(0, 0, 0), 4 * spacing, 30), spacing).size() == 1);
  CHECK(find_clusters(points_about(Vec3(0, 0, 0), 5000 * spacing, 6000), spacing).empty());
  CHECK(find_clusters({}, spacing).empty());
}

TEST_CASE("a small part of a mesh is no cluster: its points are farther apart") {
  CHECK(find_clusters(points_about(Vec3(0, 0, 0), 400 * spacing, 99), spacing).empty());
  CHECK(find_clusters(points_about(Vec3(0, 0, 0), 400 * spacing, 101), spacing).size() == 1);
}

TEST_CASE("where the next points are as near as a cluster is wide there is none") {
  std::vector<Vec3> line;  // a fine mesh: as dense everywhere
  for (int i = 0; i < 3000; ++i) line.push_back(Vec3(4 * i * spacing, 0, 0));
  CHECK(find_clusters(line, spacing).empty());
  std::vector<Vec3> near = points_about(Vec3(0, 0, 0), 1000 * spacing, 1100);
  for (int i = 0; i < 8; ++i) near.push_back(Vec3(1000 * i * spacing, 0, 0));
  CHECK(find_clusters(near, spacing).empty());
}

TEST_CASE("clusters beside each other are told apart") {
  std::vector<Vec3> points = points_about(Vec3(0, 0, 0), 10 * spacing, 50);
  for (const Vec3& p : points_about(Vec3(200 * spacing, 0, 0), 10 * spacing, 60))
    points.push_back(p);
  const std::vector<std::vector<Index>> clusters = find_clusters(points, spacing);
  REQUIRE(clusters.size() == 2);
  CHECK(clusters[0].size() + clusters[1].size() == 110);
  for (const std::vector<Index>& cluster : clusters) CHECK(is_told_apart(points, cluster));
}

TEST_CASE("clusters of random points at many scales are told apart from the rest") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    std::vector<Vec3> points;
    for (int group = 0; group < 12; ++group) {
      const double extent = std::ldexp(spacing, static_cast<int>(random.below(7)));
      for (const Vec3& p : points_about(random.point(-0.01, 0.01), extent,
                                        static_cast<std::size_t>(20 + random.below(40))))
        points.push_back(p);
    }
    for (const std::vector<Index>& cluster : find_clusters(points, spacing)) {
      CHECK(cluster.size() >= 30);
      CHECK(is_told_apart(points, cluster));
    }
  }
}

}  // namespace transformesh

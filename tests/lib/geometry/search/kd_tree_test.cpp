#include "geometry/search/kd_tree.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "geometry/search/hilbert.h"
#include "helpers/random.h"
#include "helpers/shapes.h"

using namespace transformesh;

namespace {

/// Returns all points in order of (squared distance, index).
std::vector<Index> nearest_by_search(const std::vector<Vec3>& points, const Vec3& query) {
  std::vector<std::pair<double, Index>> order;
  for (Index i = 0; i < points.size(); ++i) {
    const Vec3 d = points[i] - query;
    order.emplace_back(d.x() * d.x() + d.y() * d.y() + d.z() * d.z(), i);
  }
  std::sort(order.begin(), order.end());
  std::vector<Index> indices;
  for (const auto& [distance, index] : order) indices.push_back(index);
  return indices;
}

void check_queries(const std::vector<Vec3>& points, const std::vector<Vec3>& queries) {
  const KdTree tree(points);
  const KdTree along_curve(points, hilbert_order(points));
  for (const Vec3& query : queries) {
    auto expected = nearest_by_search(points, query);
    CHECK(tree.nearest(query) == expected[0]);
    CHECK(along_curve.nearest(query) == expected[0]);
    expected.resize(std::min<std::size_t>(expected.size(), 12));
    CHECK(tree.nearest(query, 12) == expected);
    CHECK(along_curve.nearest(query, 12) == expected);
  }
}

void check_odd_within(const std::vector<Vec3>& points, const Vec3& query, double distance) {
  const auto is_odd = [](Index i) { return i % 2 == 1; };
  Index expected = no_index;
  for (const Index i : nearest_by_search(points, query))
    if (expected == no_index && is_odd(i) && (points[i] - query).norm() < distance) expected = i;
  CHECK(KdTree(points).nearest_within(query, distance, is_odd) == expected);
}

/// Many points at few positions: every query has ties.
std::vector<Vec3> lattice_points(std::uint64_t seed, std::size_t count) {
  test::Random random(seed);
  std::vector<Vec3> points(count);
  for (Vec3& point : points)
    for (int axis = 0; axis < 3; ++axis) point[axis] = static_cast<double>(random.below(5));
  return points;
}

}  // namespace

TEST_CASE("nearest points agree with a search over random points, near and far") {
  test::Random random(1);
  for (const std::size_t count : {1, 2, 8, 9, 17, 100, 3000}) {
    std::vector<Vec3> points(count);
    for (Vec3& point : points) point = random.point(0, 1);
    std::vector<Vec3> queries;
    for (int i = 0; i < 30; ++i) {
      queries.push_back(random.point(-0.2, 1.2));
      queries.push_back(random.point(-100, 100));
      queries.push_back(points[random.below(count)]);
    }
    check_queries(points, queries);
  }
}

TEST_CASE("the lowest index wins ties") {
  for (const std::size_t count : {5, 60, 2000}) {
    auto queries = lattice_points(count + 1, 60);
    for (std::size_t i = 0; i < 30; ++i) queries[i] += Vec3(0.5, 0.5, i % 2 == 0 ? 0.5 : 0);
    check_queries(lattice_points(count, count), queries);
  }
  const std::vector<Vec3> same(10000, Vec3(1, 2, 3));
  CHECK(KdTree(same).nearest(Vec3::Zero()) == 0);
  CHECK(KdTree(same).nearest(Vec3(1, 2, 3), 3) == std::vector<Index>{0, 1, 2});
}

TEST_CASE("points on a surface, on a line and in one plane") {
  test::Random random(3);
  std::vector<Vec3> queries;
  for (int i = 0; i < 50; ++i) queries.push_back(random.point(-1.5, 1.5));
  check_queries(test::icosphere(4).positions, queries);
  check_queries(test::grid(30).positions, queries);
  std::vector<Vec3> line;
  for (int i = 0; i < 1000; ++i) line.emplace_back(std::ldexp(1.0, -i), 0, 0);
  check_queries(line, queries);
}

TEST_CASE("tiny and huge coordinates, also beyond the floats of the boxes") {
  for (const double scale : {1e-120, 1e-42, 1e-30, 1e30, 1e42, 1e120}) {
    test::Random random(4);
    std::vector<Vec3> points(500);
    for (Vec3& point : points) point = scale * random.point(-1, 1);
    std::vector<Vec3> queries(20);
    for (Vec3& query : queries) query = scale * random.point(-2, 2);
    check_queries(points, queries);
  }
}

TEST_CASE("no points, no neighbors") {
  const KdTree tree(std::vector<Vec3>{});
  CHECK(tree.nearest(Vec3::Zero()) == no_index);
  CHECK(tree.nearest(Vec3::Zero(), 5).empty());
  const KdTree three(std::vector<Vec3>(3, Vec3::Ones()));
  CHECK(three.nearest(Vec3::Zero(), 0).empty());
  CHECK(three.nearest(Vec3::Zero(), 5).size() == 3);
}

TEST_CASE("the nearest point within a distance that passes agrees with a search") {
  test::Random random(3);
  for (int i = 0; i < 200; ++i) {
    std::vector<Vec3> points(30);
    for (Vec3& point : points) point = random.point(0, 1);
    check_odd_within(points, random.point(-0.2, 1.2), random.uniform(0, 0.5));
    check_odd_within(lattice_points(i + 1U, 40), random.point(0, 4), random.uniform(0, 3));
  }
}

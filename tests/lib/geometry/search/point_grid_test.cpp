#include "geometry/search/point_grid.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "helpers/random.h"

namespace transformesh {
namespace {

constexpr double width = 0.25;

std::vector<Vec3> random_points(std::uint64_t seed, double size) {
  test::Random random(seed);
  std::vector<Vec3> points;
  for (int i = 0; i < 300; ++i) points.push_back(random.point(-size, size));
  for (int i = 0; i < 40; ++i) {  // on the borders of cells, and on both sides of zero
    const Vec3 p = random.point(-4, 4);
    points.emplace_back(width * std::round(p.x()), width * std::round(p.y()), 0);
  }
  return points;
}

PointGrid grid_of(const std::vector<Vec3>& points) {
  PointGrid grid(width);
  for (Index i = 0; i < points.size(); ++i) grid.add(points[i], i);
  return grid;
}

double distance(const Vec3& a, const Vec3& b) { return (a - b).cwiseAbs().maxCoeff(); }

}  // namespace

TEST_CASE("around a position are all points as near as the width, and none twice as far") {
  for (const double size : {1.0, 3.0}) {
    const std::vector<Vec3> points = random_points(1, size);
    const PointGrid grid = grid_of(points);
    for (const Vec3& query : random_points(2, size)) {
      std::vector<Index> visited;
      grid.visit_around(query, [&](Index i) { visited.push_back(i); });
      std::sort(visited.begin(), visited.end());
      CHECK(std::adjacent_find(visited.begin(), visited.end()) == visited.end());
      for (Index i = 0; i < points.size(); ++i) {
        const bool is_visited = std::binary_search(visited.begin(), visited.end(), i);
        if (distance(points[i], query) <= width) CHECK(is_visited);
        if (distance(points[i], query) > 2 * width) CHECK(!is_visited);
      }
    }
  }
}

TEST_CASE("every point is in one cell, with none farther than the width") {
  const std::vector<Vec3> points = random_points(3, 2);
  std::vector<int> seen(points.size(), 0);
  grid_of(points).visit_cells([&](const std::vector<Index>& cell) {
    CHECK(std::is_sorted(cell.begin(), cell.end()));
    for (const Index i : cell) {
      ++seen[i];
      CHECK(distance(points[i], points[cell.front()]) <= width);
    }
  });
  CHECK(std::count(seen.begin(), seen.end(), 1) == static_cast<std::ptrdiff_t>(points.size()));
}

TEST_CASE("cells that touch are visited once for both") {
  const std::vector<Vec3> points = random_points(4, 1);
  const auto cell_of = [](const Vec3& p) {
    return std::array{std::floor(p.x() / width), std::floor(p.y() / width),
                      std::floor(p.z() / width)};
  };
  std::set<std::array<double, 3>> cells;
  for (const Vec3& p : points) cells.insert(cell_of(p));
  std::size_t expected = 0;
  for (const auto& a : cells) {
    for (const auto& b : cells) {
      const double apart =
          std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
      expected += a < b && apart <= 1 ? 1 : 0;
    }
  }
  std::set<std::array<std::array<double, 3>, 2>> visited;
  std::size_t visits = 0;
  grid_of(points).visit_adjacent_cells([&](const auto& first, const auto& second) {
    const auto a = cell_of(points[first.front()]), b = cell_of(points[second.front()]);
    CHECK(a != b);
    visited.insert({std::min(a, b), std::max(a, b)});
    ++visits;
  });
  CHECK(visits == expected);
  CHECK(visited.size() == expected);
}

}  // namespace transformesh

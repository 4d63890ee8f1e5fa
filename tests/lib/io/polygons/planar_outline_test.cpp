#include "io/polygons/planar_outline.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "helpers/random.h"

using namespace transformesh;

namespace {

using Points = std::vector<Eigen::Vector2d>;

PlanarTriangles triangulated(const Points& points) {
  std::vector<std::uint32_t> outline(points.size());
  std::iota(outline.begin(), outline.end(), 0);
  return triangulate_outline(points, outline);
}

double signed_area(const Points& points, const std::vector<CornerTriangle>& triangles) {
  double area = 0;
  for (const auto& [a, b, c] : triangles) {
    const Eigen::Vector2d ab = points[b] - points[a], ac = points[c] - points[a];
    area += (ab.x() * ac.y() - ab.y() * ac.x()) / 2;
  }
  return area;
}

/// A star with n tips: every second corner is nearer to the center.
Points star(int n) {
  Points points;
  for (int i = 0; i < 2 * n; ++i) {
    const double angle = std::numbers::pi * i / n, radius = i % 2 == 0 ? 2 : 1;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return points;
}

}  // namespace

TEST_CASE("a star of n tips has 2n - 2 triangles with its area") {
  for (const int n : {2, 3, 5, 50}) {
    const Points points = star(n);
    const PlanarTriangles result = triangulated(points);
    CHECK(result.is_complete);
    CHECK(result.triangles.size() == points.size() - 2);
    CHECK(result.folds == 0);
    // n kites of two triangles with sides 2 and 1 and the angle pi / n between them.
    CHECK(signed_area(points, result.triangles) ==
          doctest::Approx(2 * n * std::sin(std::numbers::pi / n)));
  }
}

TEST_CASE("a clockwise outline gives clockwise triangles") {
  Points points = star(4);
  const double area = signed_area(points, triangulated(points).triangles);
  std::reverse(points.begin(), points.end());
  CHECK(signed_area(points, triangulated(points).triangles) == doctest::Approx(-area));
}

TEST_CASE("a bridge to a hole leaves the hole open") {
  // A square of side 3 around one of side 1, with a bridge from corner to corner, there and back.
  const Points points{{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0},
                      {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}};
  const PlanarTriangles result = triangulated(points);
  CHECK(result.is_complete);
  CHECK(signed_area(points, result.triangles) == doctest::Approx(8));
}

TEST_CASE("edges that cross are named, and collinear points have no triangles") {
  const PlanarTriangles bow = triangulated({{0, 0}, {1, 1}, {1, 0}, {0, 1}});
  CHECK(!bow.is_complete);
  CHECK(bow.crossing == std::vector<std::uint32_t>{2});
  const PlanarTriangles line = triangulated({{0, 0}, {1, 0}, {2, 0}, {1.5, 0}});
  CHECK(!line.is_complete);
  CHECK(line.triangles.empty());
}

TEST_CASE("the triangles of a convex outline are those whose circles are empty") {
  test::Random random(1);
  for (const int size : {4, 7, 30}) {
    Points points;
    for (int i = 0; i < size; ++i) {
      const double angle = 2 * std::numbers::pi * (i + random.uniform(0, 0.9)) / size;
      points.emplace_back(3 * std::cos(angle), std::sin(angle));
    }
    const PlanarTriangles result = triangulated(points);
    CHECK(result.triangles.size() == points.size() - 2);
    for (const auto& [a, b, c] : result.triangles) {
      Eigen::Matrix2d sides;
      sides << (points[b] - points[a]).transpose(), (points[c] - points[a]).transpose();
      const Eigen::Vector2d squares(sides.row(0).squaredNorm(), sides.row(1).squaredNorm());
      const Eigen::Vector2d center = points[a] + sides.inverse() * squares / 2;
      const double radius = (points[a] - center).norm();
      for (const Eigen::Vector2d& p : points) CHECK((p - center).norm() > radius * (1 - 1e-9));
    }
  }
}

TEST_CASE("an outline that goes around twice has each triangle twice, one of them folded") {
  const Points points{{0, 0}, {1, 0}, {0, 1}, {0, 0}, {1, 0}, {0, 1}};
  const PlanarTriangles result = triangulated(points);
  CHECK(result.is_complete);
  CHECK(result.triangles.size() == 2);
  CHECK(result.folds == 1);
  CHECK(signed_area(points, result.triangles) == doctest::Approx(1));
}

TEST_CASE("an edge through another corner has a triangle without area") {
  // The tip of a notch, corner 3, is on the edge from 0 to 1.
  const Points points{{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 2}};
  const PlanarTriangles result = triangulated(points);
  CHECK(result.is_complete);
  CHECK(result.flat == std::vector<CornerTriangle>{{0, 1, 3}});
  CHECK(result.triangles.size() == 2);
  CHECK(signed_area(points, result.triangles) == doctest::Approx(4));
}

TEST_CASE("several outlines bound a part with a hole, an edge and a point inside") {
  const Points points = {{0, 0}, {8, 0}, {8, 8}, {0, 8}, {1, 1}, {1, 3},
                         {3, 3}, {3, 1}, {5, 5}, {6, 5}, {6, 2}};
  const PlanarTriangles result =
      triangulate_outlines(points, {{0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9}, {10}});
  REQUIRE(result.is_complete);
  CHECK(result.folds == 0);
  // 8 corners and a hole have 8 triangles, and 3 vertices inside add two each.
  CHECK(result.triangles.size() == 14);
  CHECK(signed_area(points, result.triangles) == doctest::Approx(60));
  const auto has = [&](std::uint32_t from, std::uint32_t to) {
    return std::count_if(result.triangles.begin(), result.triangles.end(), [&](const auto& t) {
      return (t[0] == from && t[1] == to) || (t[1] == from && t[2] == to) ||
             (t[2] == from && t[0] == to);
    });
  };
  CHECK(has(8, 9) == 1);
  CHECK(has(9, 8) == 1);
  CHECK(has(4, 5) == 1);
  CHECK(has(5, 4) == 0);
}

TEST_CASE("two outlines beside each other are two parts, and a point outside is in none") {
  const Points points = {{0, 0}, {1, 0}, {0, 1}, {4, 0}, {5, 0}, {4, 1}, {9, 9}};
  const PlanarTriangles result = triangulate_outlines(points, {{0, 1, 2}, {3, 4, 5}, {6}});
  CHECK(result.is_complete);
  CHECK(result.triangles.size() == 2);
}

TEST_CASE("outlines that cross, and edges without length, are not complete") {
  const Points points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}, {6, 2}, {6, 3}};
  const PlanarTriangles crossing = triangulate_outlines(points, {{0, 1, 2, 3}, {4, 5, 6}});
  CHECK(!crossing.is_complete);
  CHECK(!crossing.crossing.empty());
  const Points twice = {{0, 0}, {4, 0}, {4, 0}, {0, 4}};
  const PlanarTriangles without_length = triangulated(twice);
  CHECK(!without_length.is_complete);
  CHECK(without_length.crossing == std::vector<std::uint32_t>{1});
}

/// Triangulations of random polygons, compared with CGAL's search and the definition of a
/// triangulation.
#include "fill/hole_triangulation.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>

using namespace transformesh;

namespace {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

/// Points around a circle, moved at random. Flat polygons have ties.
HoleBorder random_border(std::mt19937& random, Index size, double noise) {
  std::uniform_real_distribution<double> shift(-noise, noise);
  HoleBorder border;
  for (Index i = 0; i < size; ++i) {
    const double angle = 2 * std::numbers::pi * i / size;
    const Vec3 p(std::cos(angle) + shift(random), std::sin(angle) + shift(random), shift(random));
    border.points.push_back(p);
    border.across.emplace_back(1.5 * p + Vec3(0, 0, shift(random)));
  }
  return border;
}

/// Counts the triangles at each edge.
void check_triangulation(const HoleBorder& border, const std::vector<HoleTriangle>& triangles) {
  const auto size = static_cast<Index>(border.points.size());
  REQUIRE(triangles.size() + 2 == size);
  std::map<std::pair<Index, Index>, int> edges;
  for (const auto& [i, m, k] : triangles) {
    CHECK((i < m && m < k));
    for (const auto& edge : {std::pair(i, m), std::pair(m, k), std::pair(i, k)}) ++edges[edge];
  }
  CHECK(edges.size() == 2 * size - 3);
  for (const auto& [edge, count] : edges) {
    const auto [i, k] = edge;
    CHECK(count == (k == i + 1 || k == i + size - 1 ? 1 : 2));
    CHECK(!std::binary_search(border.chords.begin(), border.chords.end(), edge));
  }
}

std::vector<HoleTriangle> sorted(std::vector<HoleTriangle> triangles) {
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

std::vector<HoleTriangle> by_cgal(const HoleBorder& border) {
  std::vector<Point> points, across;
  for (const Vec3& p : border.points) points.emplace_back(p.x(), p.y(), p.z());
  for (const Vec3& p : border.across) across.emplace_back(p.x(), p.y(), p.z());
  struct Triangle {
    HoleTriangle corners;
    Triangle(int i, int m, int k)
        : corners{static_cast<Index>(i), static_cast<Index>(m), static_cast<Index>(k)} {}
  };
  std::vector<Triangle> found;
  CGAL::Polygon_mesh_processing::triangulate_hole_polyline(
      points, across, std::back_inserter(found),
      CGAL::parameters::use_delaunay_triangulation(false).use_2d_constrained_delaunay_triangulation(
          false));
  std::vector<HoleTriangle> triangles;
  for (const Triangle& triangle : found) triangles.push_back(triangle.corners);
  return triangles;
}

}  // namespace

TEST_CASE("the least triangulation is that of CGAL, ties included") {
  std::mt19937 random(5);
  for (int trial = 0; trial < 60; ++trial) {
    CAPTURE(trial);
    const HoleBorder border = random_border(random, 3 + random() % 60, trial % 4 == 0 ? 0 : 0.3);
    const std::vector<HoleTriangle> triangles = least_triangulation(border);
    check_triangulation(border, triangles);
    CHECK(sorted(triangles) == sorted(by_cgal(border)));
  }
}

TEST_CASE("no triangulation has edges that the mesh has, or triangles without area") {
  std::mt19937 random(6);
  for (int trial = 0; trial < 40; ++trial) {
    CAPTURE(trial);
    const Index size = 20 + random() % 100;
    HoleBorder border = random_border(random, size, 0.02);
    for (Index i = 0; i + 2 < size; i += 2) border.chords.emplace_back(i, i + 2);
    check_triangulation(border, least_triangulation(border));
    check_triangulation(border, sparse_triangulation(border));
    check_triangulation(border, greedy_triangulation(border));
  }
  HoleBorder line = random_border(random, 5, 0.1);
  for (Index i = 0; i < 5; ++i) line.points[i] = Vec3(i * (4 - i), 0, 0);
  CHECK(least_triangulation(line).empty());
  CHECK(sparse_triangulation(line).empty());
  CHECK(greedy_triangulation(line).empty());
}

#include "io/polygons/triangulate_polygon.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>

#include "lib/io/polygons/outlines.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

using Triangles = std::vector<CornerTriangle>;

PolygonTriangles cut(const TestPolygon& polygon) {
  return triangulate_polygon(polygon.positions(), polygon.corners);
}

PolygonTriangles cut(const std::vector<Vec3>& positions) {
  std::vector<Index> vertices(positions.size());
  std::iota(vertices.begin(), vertices.end(), 0U);
  return triangulate_polygon(positions, vertices);
}

/// Returns a random rotation. Rounding makes a rotated polygon slightly non-planar.
Eigen::Matrix3d random_rotation(test::Random& random) {
  Eigen::Quaterniond turn(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1),
                          random.uniform(-1, 1));
  return turn.normalized().toRotationMatrix();
}

double area_of(const Triangles& triangles, const std::vector<Vec3>& positions) {
  double area = 0;
  for (const auto& [a, b, c] : triangles)
    area += (positions[b] - positions[a]).cross(positions[c] - positions[a]).norm() / 2;
  return area;
}

/// Returns the least number of faults among projections along the axes close to the normal. If two
/// axes are nearly equally close, rounding decides which one the library uses.
std::size_t fewest_faults(const Triangles& triangles, const std::vector<Vec3>& positions,
                          const Vec3& normal, int least) {
  std::size_t fewest = triangles.size();
  for (const int axis : {0, 1, 2}) {
    if (std::abs(normal[axis]) < 0.5 * normal.cwiseAbs().maxCoeff()) continue;
    const int sign = normal[axis] > 0 ? 1 : -1;
    fewest = std::min(fewest, count_faults(in_projection(triangles, positions, axis, sign), least));
  }
  return fewest;
}

/// Checks a polygon that has a triangulation without folds.
void check_unfolded(const TestPolygon& polygon, int least = 1) {
  const std::vector<Vec3> positions = polygon.positions();
  const PolygonTriangles result = cut(polygon);
  CHECK(result.folds + result.upright == 0);
  CHECK(result.triangles.size() == positions.size() - 2);
  CHECK(boundary_of(result.triangles, polygon.corners) == boundary_of(polygon.corners));
  const Vec3 normal = normal_of(positions);
  CHECK(fewest_faults(result.triangles, positions, normal, least) == 0);
  CHECK(area_of(result.triangles, positions) == doctest::Approx(normal.norm() / 2).epsilon(1e-10));
}

/// Checks the polygon at several heights, reversed, starting at another corner, and rotated.
void check_everywhere(TestPolygon polygon, test::Random& random) {
  for (const double height : {0.0, 0.1, 1.0, 9.0, 1e6}) {
    for (Vec3& point : polygon.points) point[2] = height;
    check_unfolded(polygon);
  }
  std::reverse(polygon.corners.begin(), polygon.corners.end());
  check_unfolded(polygon);
  for (int round = 0; round < 4; ++round) {
    const Eigen::Matrix3d rotation = random_rotation(random);
    TestPolygon turned = polygon;
    for (Vec3& point : turned.points) point = rotation * point;
    const auto first = static_cast<std::ptrdiff_t>(random.below(turned.corners.size()));
    std::rotate(turned.corners.begin(), turned.corners.begin() + first, turned.corners.end());
    // After rounding, three collinear corners may lie on either side of their line, and in a
    // projection exactly on it.
    check_unfolded(turned, 0);
  }
}

TestPolygon crossed_square() {
  return {{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2, 3}};
}

}  // namespace

TEST_CASE("a polygon without folds from its first corner stays a fan") {
  CHECK(cut({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}).triangles ==
        Triangles{{0, 1, 2}, {0, 2, 3}});
  // A polygon that is star-shaped as seen from its first corner, which is a reflex corner.
  CHECK(cut({{0, 0, 5}, {2, -1, 5}, {0, 2, 5}, {-2, -1, 5}}).triangles ==
        Triangles{{0, 1, 2}, {0, 2, 3}});
  // A non-planar polygon with a fold over a diagonal, as seen from above.
  CHECK(cut({{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}}).triangles ==
        Triangles{{0, 1, 2}, {0, 2, 3}});
}

TEST_CASE("concave polygons are not cut as fans that fold") {
  const PolygonTriangles result =
      cut({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {1, 1, 0}, {0, 1, 0}});
  CHECK(result.triangles.size() == 4);
  CHECK(result.folds == 0);
  CHECK(cut({{0, 0, 0}, {2, 0, 0}, {0.5, 0.5, 0}, {0, 2, 0}}).triangles ==
        Triangles{{0, 1, 2}, {0, 2, 3}});
  CHECK(cut({{2, 0, 0}, {0.5, 0.5, 0}, {0, 2, 0}, {0, 0, 0}}).triangles ==
        Triangles{{0, 1, 3}, {1, 2, 3}});
}

TEST_CASE("generated polygons are triangulated without folds at every height and turned") {
  test::Random random(1);
  for (int round = 0; round < 40; ++round) {
    const std::size_t size = 4 + random.below(14);
    check_everywhere(random_star(size, random), random);
    check_everywhere(with_middles(comb(1 + static_cast<int>(random.below(3))), random), random);
  }
  check_everywhere(spiral(14, 2), random);
  check_everywhere(comb(5), random);
}

TEST_CASE("holes reached by bridges stay open") {
  test::Random random(2);
  for (int round = 0; round < 20; ++round) {
    const TestPolygon plate = plate_with_holes(1 + static_cast<int>(random.below(3)), random);
    check_everywhere(plate, random);
    check_everywhere(with_middles(plate, random), random);
  }
  const TestPolygon ring{
      {{0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {0, 4, 1}, {1, 1, 1}, {3, 1, 1}, {3, 3, 1}, {1, 3, 1}},
      {0, 1, 2, 3, 0, 4, 7, 6, 5, 4}};
  check_everywhere(ring, random);
  CHECK(area_of(cut(ring).triangles, ring.positions()) == 12);
}

TEST_CASE("a bridge between vertices of their own at equal places leaves the hole open, too") {
  const TestPolygon ring{{{0, 0, 0},
                          {4, 0, 0},
                          {4, 4, 0},
                          {0, 4, 0},
                          {0, 0, 0},
                          {1, 1, 0},
                          {1, 3, 0},
                          {3, 3, 0},
                          {3, 1, 0},
                          {1, 1, 0}},
                         {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}};
  check_unfolded(ring);
}

TEST_CASE("an edge that runs through another corner is kept, by a triangle without area") {
  // A notch whose tip is on the bottom edge.
  const TestPolygon notched{{{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {2, 0, 0}, {0, 2, 0}},
                            {0, 1, 2, 3, 4}};
  const PolygonTriangles result = cut(notched);
  CHECK(result.folds == 0);
  CHECK(boundary_of(result.triangles, notched.corners) == boundary_of(notched.corners));
  CHECK(area_of(result.triangles, notched.positions()) == 4);
}

TEST_CASE("repeated corners and spikes go") {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, 0}};
  const Triangles only = cut({points, {0, 0, 1, 1, 2, 2}}).triangles;
  REQUIRE(only.size() == 1);
  CHECK(only[0][0] / 2 == 0);
  CHECK(only[0][1] / 2 == 1);
  CHECK(only[0][2] / 2 == 2);
  CHECK(cut({points, {0, 1, 2, 3, 2}}).triangles.size() == 1);
  CHECK(cut({points, {0, 1, 0, 1}}).triangles.empty());
  CHECK(cut({points, {3, 3, 3, 3, 3}}).triangles.empty());
  CHECK(cut({points, {0, 1}}).triangles.empty());
}

TEST_CASE("an outline that intersects itself has folds, and the boundary of its polygon") {
  CHECK(cut(crossed_square()).folds == 1);
  CHECK(cut(crossed_square()).triangles.size() == 2);
  // The projection from above intersects itself; the one from the front does not.
  CHECK(cut({{0, 0, 0}, {1, 1, 1}, {1, 0, 3}, {0, 1, 2}}).folds == 0);
  // Two loops that meet in a corner and have opposite orientations.
  const TestPolygon eight{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, -2, 0}, {-1, 0, 0}},
                          {0, 1, 2, 0, 4, 3}};
  CHECK(cut(eight).triangles == Triangles{{0, 1, 2}, {3, 4, 5}});
  test::Random random(7);
  for (int round = 0; round < 2000; ++round) {
    TestPolygon polygon;
    for (std::size_t i = 2 + random.below(12); i > 0; --i)
      polygon.points.emplace_back(static_cast<double>(random.below(4)),
                                  static_cast<double>(random.below(4)),
                                  round % 2 == 0 ? 0 : random.uniform(0, 1));
    for (std::size_t i = 4 + random.below(30); i > 0; --i)
      polygon.corners.push_back(static_cast<Index>(random.below(polygon.points.size())));
    const PolygonTriangles result = cut(polygon);
    CHECK(boundary_of(result.triangles, polygon.corners) == boundary_of(polygon.corners));
    CHECK(result.triangles.size() <= 3 * polygon.corners.size());
    for (const auto& [a, b, c] : result.triangles)
      CHECK(!is_collapsed({polygon.corners[a], polygon.corners[b], polygon.corners[c]}));
  }
}

TEST_CASE("coordinates of any magnitude are decided exactly") {
  for (const double scale : {1e-300, 1e-160, 1e160, 1e300}) {
    std::vector<Vec3> positions{{0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {1, 2, 1}, {1, 1, 1}, {0, 1, 1}};
    for (Vec3& position : positions) position *= scale;
    const PolygonTriangles result = cut(positions);
    CHECK(result.folds == 0);
    CHECK(result.triangles.size() == 4);
    CHECK(count_faults(in_projection(result.triangles, positions, 2, 1)) == 0);
  }
}

TEST_CASE("100,000 corners do not take quadratic time") {
  const auto check_size = [](const TestPolygon& polygon) {
    const PolygonTriangles result = cut(polygon);
    CHECK(result.folds == 0);
    CHECK(result.triangles.size() == polygon.corners.size() - 2);
  };
  check_size(comb(25000));
  check_size(spiral(50000, 200));
  // Outlines that intersect or overlap themselves do not take quadratic time, either.
  test::Random random(3);
  TestPolygon crossing, line;
  for (int i = 0; i < 50000; ++i) {
    crossing.add(random.uniform(0, 1), random.uniform(0, 1));
    line.add(static_cast<double>(random.below(100)), 0);
  }
  line.add(0, 1);
  CHECK(cut(crossing).triangles.size() == crossing.corners.size() - 2);
  CHECK(cut(line).triangles.size() == line.corners.size() - 2);
}

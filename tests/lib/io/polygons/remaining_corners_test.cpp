#include "io/polygons/remaining_corners.h"

#include <doctest/doctest.h>

#include "lib/io/polygons/outlines.h"

using namespace transformesh;

namespace {

/// A polygon in the plane z = 0, projected along z.
struct Polygon {
  std::vector<Vec3> positions;
  std::vector<Index> vertices;
  std::vector<Eigen::Vector2d> points;

  explicit Polygon(const std::vector<Eigen::Vector2d>& corners) : points(corners) {
    for (const Eigen::Vector2d& corner : corners) {
      vertices.push_back(static_cast<Index>(positions.size()));
      positions.emplace_back(corner.x(), corner.y(), 0);
    }
  }
  RemainingCorners corners() const { return {positions, vertices, points}; }
};

using Corners = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("all corners are there at first, and a fan from the first cuts all off") {
  const Polygon square({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  RemainingCorners corners = square.corners();
  CHECK(corners.corners() == Corners{0, 1, 2, 3});
  CHECK(!corners.has_twins());
  corners.cut_fan();
  CHECK(corners.triangles == std::vector<CornerTriangle>{{0, 1, 2}, {0, 2, 3}});
  CHECK(corners.folds == 2);
}

TEST_CASE("corners at one point are twins, and consecutive ones are cut off") {
  const Polygon polygon({{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}});
  RemainingCorners corners = polygon.corners();
  CHECK(corners.has_twins());
  corners.remove_coincident();
  CHECK(corners.size() == 4);
  CHECK(corners.triangles.size() == 1);
}

TEST_CASE("a spike whose ends have one point is cut off") {
  const Polygon polygon({{0, 0}, {1, 0}, {5, 5}, {1, 0}, {1, 1}, {0, 1}});
  RemainingCorners corners = polygon.corners();
  corners.remove_coincident();
  CHECK(corners.size() == 4);
  CHECK(corners.triangles.size() == 2);
}

TEST_CASE("the end of an edge with the smaller triangle is cut off") {
  // Corner 1 lies close to the line from 0 to 2, corner 2 far from the line from 1 to 3.
  const Polygon polygon({{0, 0}, {1, -0.1}, {2, 0}, {2, 2}, {0, 2}});
  RemainingCorners corners = polygon.corners();
  corners.cut_edge(1, 1);
  CHECK(corners.corners() == Corners{0, 2, 3, 4});
  CHECK(corners.triangles == std::vector<CornerTriangle>{{0, 1, 2}});
}

TEST_CASE("collinearity is exact") {
  CHECK(is_collinear({0, 0, 0}, {1, 2, 3}, {3, 6, 9}));
  CHECK(is_collinear({.5, .5, .5}, {.5, .5, .5}, {1, 2, 3}));
  CHECK(!is_collinear({0, 0, 0}, {1, 2, 3}, {3, 6, std::nextafter(9.0, 10.0)}));
}

TEST_CASE("whatever is cut off, the triangles and the rest have the boundary of the polygon") {
  test::Random random(4);
  for (int round = 0; round < 50; ++round) {
    const auto size = static_cast<std::uint32_t>(4 + random.below(9));
    std::vector<Eigen::Vector2d> places;
    for (std::uint32_t i = 0; i < size; ++i) places.emplace_back(random.below(3), random.below(3));
    const Polygon polygon(places);
    RemainingCorners corners = polygon.corners();
    corners.remove_coincident();
    for (int i = 0; i < 3; ++i)
      corners.cut_edge(static_cast<std::uint32_t>(random.below(size)), 1 + random.below(2));
    const Corners rest = corners.corners();
    CHECK(rest.size() == corners.size());
    CHECK(corners.triangles.size() + rest.size() == size);
    testing::Boundary boundary = testing::boundary_of(corners.triangles, polygon.vertices);
    for (std::size_t i = 0; i < rest.size(); ++i)
      testing::add_edge(boundary, rest[i], rest[(i + 1) % rest.size()]);
    CHECK(boundary == testing::boundary_of(polygon.vertices));
  }
}

TEST_CASE("triangles without area in the projection count if they have one in space") {
  Polygon polygon({{0, 0}, {0, 0}, {1, 0}, {2, 0}, {0, 1}});
  polygon.positions[1].z() = 1;  // above corner 0
  RemainingCorners corners = polygon.corners();
  corners.remove_coincident();
  CHECK(corners.size() == 4);
  CHECK(corners.upright == 1);
  corners.add_flat({0, 2, 3});  // collinear in space, too
  CHECK(corners.upright == 1);
  CHECK(corners.folds == 0);
}

#include "io/polygons/triangulate_polygon.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/numbers/predicates.h"
#include "io/polygons/remaining_corners.h"

namespace transformesh {
namespace {

using Point = Eigen::Vector2d;

/// Projects a point to two coordinates: its dot products with the vectors u and v. If these are
/// axes, the coordinates are the original doubles.
struct Projection {
  Vec3 u, v;

  Point operator()(const Vec3& position) const { return {u.dot(position), v.dot(position)}; }
};

/// Returns Newell's normal of the polygon, for coordinates scaled to at most 1.
Vec3 polygon_normal(std::span<const Vec3> positions) {
  double largest = 0;
  for (const Vec3& position : positions)
    largest = std::max(largest, position.cwiseAbs().maxCoeff());
  Vec3 normal = Vec3::Zero();
  if (largest == 0) return normal;
  const Vec3 origin = positions[0] / largest;
  Vec3 edge = Vec3::Zero();
  for (std::size_t i = 1; i < positions.size(); ++i) {
    const Vec3 next = positions[i] / largest - origin;
    normal += edge.cross(next);
    edge = next;
  }
  return normal;
}

Projection along_axis(Eigen::Index axis) {
  return {Vec3::Unit((axis + 1) % 3), Vec3::Unit((axis + 2) % 3)};
}

/// Returns the axis nearest to the normal. Ties are decided in favor of the last axis.
Eigen::Index axis_nearest_to(const Vec3& normal) {
  const Vec3 size = normal.cwiseAbs();
  if (size[2] >= size[0] && size[2] >= size[1]) return 2;
  return size[1] >= size[0] ? 1 : 0;
}

/// Returns alternative projections: along `normal`, if it is not zero, and along the two axes other
/// than `nearest`.
std::vector<Projection> other_projections(const Vec3& normal, Eigen::Index nearest) {
  std::vector<Projection> others;
  const Vec3 direction = normal.stableNormalized();
  if (!direction.isZero()) {
    const Vec3 across = direction.unitOrthogonal();
    others.push_back({across, direction.cross(across)});
  }
  others.push_back(along_axis((nearest + 1) % 3));
  others.push_back(along_axis((nearest + 2) % 3));
  return others;
}

int orientation(const Point& a, const Point& b, const Point& c) {
  using Exact = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  return CGAL::orientation(Exact(a[0], a[1]), Exact(b[0], b[1]), Exact(c[0], c[1]));
}

/// Tests the triangle fan from the first corner. Its triangles must have one orientation in a
/// projection and an area in space. The fan must turn by less than 360 degrees.
class FanCheck {
 public:
  FanCheck(std::span<const Vec3> positions, const Projection& projected)
      : positions_(positions), projected_(projected), apex_(projected(positions[0])) {}

  bool is_fan() {
    for (std::size_t i = 1; i < positions_.size(); ++i) {
      const Point corner = projected_(positions_[i]);
      const Point before = projected_(positions_[i - 1]);
      const bool has_area = i == 1 || orientation(apex_, before, corner) != 0 ||
                            !collinear(positions_[0], positions_[i - 1], positions_[i]);
      if (!has_area || (corner != apex_ && !turns_to(corner))) return false;
    }
    return sign_ != 0;
  }

 private:
  bool turns_to(const Point& corner) {
    if (!first_) {
      first_ = last_ = corner;
      return true;
    }
    const int turn = orientation(apex_, *last_, corner);
    if (turn == 0 && (*last_ - apex_).dot(corner - apex_) <= 0) return false;
    if (sign_ == 0) sign_ = turn;
    if (turn != 0 && turn != sign_) return false;
    last_ = corner;
    const int side = sign_ * orientation(apex_, *first_, corner);
    if (is_beyond_half_ && side >= 0) return false;  // the fan turns by more than 360 degrees
    is_beyond_half_ = side < 0;
    return true;
  }

  std::span<const Vec3> positions_;
  const Projection& projected_;
  Point apex_;
  /// First and last corner that differs from the apex in the projection.
  std::optional<Point> first_, last_;
  int sign_ = 0;
  bool is_beyond_half_ = false;
};

PolygonTriangles fan_of(std::size_t size) {
  PolygonTriangles fan;
  fan.triangles.reserve(size - 2);
  for (std::uint32_t i = 2; i < size; ++i) fan.triangles.push_back({0, i - 1, i});
  return fan;
}

/// Puts triangles in a canonical order: rotates each triangle so that its lowest corner is first,
/// and sorts the triangles.
void sort_triangles(std::vector<CornerTriangle>& triangles) {
  for (CornerTriangle& triangle : triangles)
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                triangle.end());
  std::sort(triangles.begin(), triangles.end());
}

using Edge = std::pair<Index, Index>;

/// Returns the edges between different vertices, without pairs of opposite edges.
std::vector<Edge> boundary_of(std::vector<Edge> edges) {
  const auto without_direction = [](const Edge& edge) {
    return Edge(std::minmax(edge.first, edge.second));
  };
  std::erase_if(edges, [](const Edge& edge) { return edge.first == edge.second; });
  std::sort(edges.begin(), edges.end(), [&](const Edge& a, const Edge& b) {
    return std::pair(without_direction(a), a) < std::pair(without_direction(b), b);
  });
  std::vector<Edge> boundary;
  for (const Edge& edge : edges) {
    if (!boundary.empty() && boundary.back() == Edge(edge.second, edge.first))
      boundary.pop_back();
    else
      boundary.push_back(edge);
  }
  return boundary;
}

/// True if the oriented boundary of the triangles is the outline, by vertex indices. It can differ
/// if several corners with different vertices have the same projection.
bool bounds(const PlanarTriangles& result, std::span<const std::uint32_t> outline,
            std::span<const Index> vertices) {
  std::vector<Edge> inside, around;
  for (const auto* triangles : {&result.triangles, &result.flat})
    for (const CornerTriangle& triangle : *triangles)
      for (std::size_t i = 0; i < 3; ++i)
        inside.emplace_back(vertices[triangle[i]], vertices[triangle[(i + 1) % 3]]);
  for (std::size_t i = 0; i < outline.size(); ++i)
    around.emplace_back(vertices[outline[i]], vertices[outline[(i + 1) % outline.size()]]);
  return boundary_of(std::move(inside)) == boundary_of(std::move(around));
}

/// Triangulates a polygon in one projection. While edges intersect, cuts off corners at these
/// edges. Each round cuts off more corners at each edge.
PolygonTriangles triangulate_along(const Projection& projected, std::span<const Vec3> positions,
                                   std::span<const Index> vertices) {
  // Growth factor, from round to round, of the number of corners that are cut off at an edge. A
  // choice: with a smaller factor, more rounds are needed; with a larger factor, corners are cut
  // off without need.
  constexpr std::size_t growth = 4;
  std::vector<Point> points;
  points.reserve(positions.size());
  for (const Vec3& position : positions) points.push_back(projected(position));
  RemainingCorners outline(positions, vertices, points);
  PlanarTriangles rest;
  for (std::size_t length = 1; !rest.is_complete; length *= growth) {
    outline.remove_coincident();
    if (outline.size() < 3) break;
    const std::vector<std::uint32_t> corners = outline.corners();
    rest = triangulate_outline(points, corners);
    if (rest.is_complete && outline.has_twins() && !bounds(rest, corners, vertices)) rest = {};
    for (const std::uint32_t corner : rest.crossing) outline.cut_edge(corner, length);
    if (!rest.is_complete && rest.crossing.empty()) outline.cut_fan();
  }
  if (rest.is_complete) {
    for (const CornerTriangle& triangle : rest.flat) outline.add_flat(triangle);
  } else {  // no remaining triangle has area in the projection
    outline.folds += std::exchange(outline.upright, 0);
  }
  PolygonTriangles result{std::move(outline.triangles), outline.folds + rest.folds,
                          outline.upright};
  result.triangles.insert(result.triangles.end(), rest.triangles.begin(), rest.triangles.end());
  sort_triangles(result.triangles);
  return result;
}

}  // namespace

bool is_unfolded_fan(std::span<const Vec3> positions) {
  if (positions.size() < 3) return false;
  return FanCheck(positions, along_axis(axis_nearest_to(polygon_normal(positions)))).is_fan();
}

PolygonTriangles triangulate_polygon(std::span<const Vec3> positions,
                                     std::span<const Index> vertices) {
  if (positions.size() < 3) return {};
  if (is_unfolded_fan(positions)) return fan_of(positions.size());
  const Vec3 normal = polygon_normal(positions);
  const Eigen::Index axis = axis_nearest_to(normal);
  PolygonTriangles best = triangulate_along(along_axis(axis), positions, vertices);
  if (best.folds + best.upright == 0) return best;
  for (const Projection& projection : other_projections(normal, axis)) {
    PolygonTriangles other = triangulate_along(projection, positions, vertices);
    if (other.folds + other.upright < best.folds + best.upright) best = std::move(other);
  }
  return best;
}

}  // namespace transformesh

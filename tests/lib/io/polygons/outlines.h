/// Generated outlines of polygons in the plane z = 0, and exact facts about their triangulations,
/// computed without the library.
#pragma once

#include <cmath>
#include <map>
#include <numbers>
#include <span>
#include <vector>

#include "helpers/random.h"
#include "helpers/rational.h"
#include "io/polygons/triangulate_polygon.h"

namespace transformesh::testing {

/// `corners` are indices of `points`. A point that the outline visits twice occurs twice.
struct TestPolygon {
  std::vector<Vec3> points;
  std::vector<Index> corners;

  std::vector<Vec3> positions() const {
    std::vector<Vec3> result;
    for (const Index corner : corners) result.push_back(points[corner]);
    return result;
  }
  void add(double x, double y) {
    corners.push_back(static_cast<Index>(points.size()));
    points.emplace_back(x, y, 0);
  }
};

/// Returns a star-shaped polygon with corners at random distances from its center.
inline TestPolygon random_star(std::size_t size, test::Random& random) {
  TestPolygon polygon;
  for (std::size_t i = 0; i < size; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(size);
    const double radius = random.uniform(0.05, 1);
    polygon.add(radius * std::cos(angle), radius * std::sin(angle));
  }
  return polygon;
}

/// Returns a bar with rectangular teeth.
inline TestPolygon comb(int teeth) {
  TestPolygon polygon;
  for (int i = 0; i < teeth; ++i) {
    polygon.add(2 * i, 0);
    polygon.add(2 * i, 10);
    polygon.add(2 * i + 1, 10);
    polygon.add(2 * i + 1, 0);
  }
  polygon.add(2 * teeth, -1);
  polygon.add(0, -1);
  return polygon;
}

inline TestPolygon spiral(int size, int turns) {
  TestPolygon polygon;
  for (int side = 0; side < 2; ++side)
    for (int i = 0; i < size; ++i) {
      const double step = static_cast<double>(side == 0 ? i : size - 1 - i) / size;
      const double angle = 2 * std::numbers::pi * turns * step;
      polygon.add((1 + angle + side) * std::cos(angle), (1 + angle + side) * std::sin(angle));
    }
  return polygon;
}

/// Returns a bar with a row of holes, each connected from below by a bridge with two coincident
/// sides.
inline TestPolygon plate_with_holes(int holes, test::Random& random) {
  TestPolygon polygon;
  const auto add_hole = [&](double x, double y, int size) {
    const auto first = static_cast<Index>(polygon.points.size());
    for (int i = 0; i < size; ++i) {  // clockwise from its lowest point
      const double angle = -std::numbers::pi * (0.5 + 2.0 * i / size);
      const double radius = i == 0 ? 0.45 : random.uniform(0.1, 0.45);
      polygon.add(x + radius * std::cos(angle), y + radius * std::sin(angle));
    }
    polygon.corners.push_back(first);
  };
  for (int i = 0; i < holes; ++i) {
    polygon.add(i, 0);
    polygon.add(i + 0.5, 0);
    const Index foot = polygon.corners.back();
    add_hole(i + 0.5, 1, 3 + static_cast<int>(random.below(6)));
    polygon.corners.push_back(foot);
  }
  polygon.add(holes, 0);
  polygon.add(holes, 2);
  polygon.add(0, 2);
  return polygon;
}

/// Adds corners at the middle of some edges. They lie exactly on the edges before any rotation if
/// coordinates have few digits.
inline TestPolygon with_middles(const TestPolygon& polygon, test::Random& random) {
  TestPolygon result{polygon.points, {}};
  std::map<std::pair<Index, Index>, Index> middles;
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    const Index from = polygon.corners[i];
    const Index to = polygon.corners[(i + 1) % polygon.corners.size()];
    result.corners.push_back(from);
    const auto [middle, is_new] = middles.emplace(std::minmax(from, to), no_index);
    if (is_new && random.below(2) == 0) {
      middle->second = static_cast<Index>(result.points.size());
      result.points.push_back((polygon.points[from] + polygon.points[to]) / 2);
    }
    if (middle->second != no_index) result.corners.push_back(middle->second);
  }
  return result;
}

/// Counts for each edge how often it is traversed forward, minus how often backward.
using Boundary = std::map<std::pair<Index, Index>, int>;

inline void add_edge(Boundary& boundary, Index from, Index to) {
  if (from == to) return;
  const auto edge = std::minmax(from, to);
  if ((boundary[edge] += from < to ? 1 : -1) == 0) boundary.erase(edge);
}

inline Boundary boundary_of(std::span<const Index> corners) {
  Boundary boundary;
  for (std::size_t i = 0; i < corners.size(); ++i)
    add_edge(boundary, corners[i], corners[(i + 1) % corners.size()]);
  return boundary;
}

inline Boundary boundary_of(const std::vector<CornerTriangle>& triangles,
                            std::span<const Index> corners) {
  Boundary boundary;
  for (const CornerTriangle& triangle : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      add_edge(boundary, corners[triangle[i]], corners[triangle[(i + 1) % 3]]);
  return boundary;
}

using RationalPlanePoint = std::array<test::Rational, 2>;

inline int turn(const RationalPlanePoint& a, const RationalPlanePoint& b,
                const RationalPlanePoint& c) {
  const test::Rational sign = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  return sign.sign();
}

using PlaneTriangle = std::array<RationalPlanePoint, 3>;

/// Returns the triangles projected along an axis, oriented so that the polygon's area is positive.
inline std::vector<PlaneTriangle> in_projection(const std::vector<CornerTriangle>& triangles,
                                                const std::vector<Vec3>& positions, int axis,
                                                int sign) {
  std::vector<PlaneTriangle> result;
  const auto point = [&](std::uint32_t corner) {
    return RationalPlanePoint{test::Rational(positions[corner][(axis + 1) % 3]),
                              test::Rational(positions[corner][(axis + 2) % 3])};
  };
  for (const auto& [a, b, c] : triangles) {
    result.push_back({point(a), point(b), point(c)});
    if (sign < 0) std::swap(result.back()[1], result.back()[2]);
  }
  return result;
}

/// Returns whether an edge of the first triangle separates the two. Both are counterclockwise.
inline bool separates(const PlaneTriangle& first, const PlaneTriangle& second) {
  for (std::size_t i = 0; i < 3; ++i) {
    bool is_outside = true;
    for (const RationalPlanePoint& point : second)
      is_outside = is_outside && turn(first[i], first[(i + 1) % 3], point) <= 0;
    if (is_outside) return true;
  }
  return false;
}

/// Counts the triangles whose orientation, the sign of their area, is below `least` (0: clockwise;
/// 1: also without area), and the pairs that overlap.
inline std::size_t count_faults(const std::vector<PlaneTriangle>& triangles, int least = 1) {
  std::size_t faults = 0;
  for (const PlaneTriangle& triangle : triangles)
    if (turn(triangle[0], triangle[1], triangle[2]) < least) ++faults;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!separates(triangles[i], triangles[j]) && !separates(triangles[j], triangles[i]))
        ++faults;
  return faults;
}

/// Returns Newell's normal in doubles.
inline Vec3 normal_of(const std::vector<Vec3>& positions) {
  Vec3 normal = Vec3::Zero();
  for (std::size_t i = 0; i < positions.size(); ++i)
    normal +=
        (positions[i] - positions[0]).cross(positions[(i + 1) % positions.size()] - positions[0]);
  return normal;
}

}  // namespace transformesh::testing

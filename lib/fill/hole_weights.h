/// Weights by which triangulations of holes are compared. They are equal to those of CGAL bit for
/// bit. This file includes CGAL, so only sources of this folder may include it.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "fill/hole_triangulation.h"

namespace transformesh {

/// Weight of a triangulation: its largest angle between normals of neighboring triangles, in
/// degrees, and its area. Triangulations with a smaller angle are better; of those with equal
/// angles, the one with the smaller area is better. The angle is infinite if there is no
/// triangulation.
struct HoleWeight {
  double angle = std::numeric_limits<double>::infinity();
  double area = 0;
  bool is_there() const { return angle < std::numeric_limits<double>::infinity(); }
  bool operator<(const HoleWeight& other) const {
    return angle != other.angle ? angle < other.angle : area < other.area;
  }
};

/// The best triangulation of a subpolygon, which consists of the border points from i to k and the
/// edge (i, k). Stores its weight, and the third corner (`apex`) of the triangle at the edge (i,
/// k). If k is i + 1, there is no triangle.
struct HoleSubpolygon {
  HoleWeight weight;
  Index apex = no_index;
};

class HoleWeights {
 public:
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  explicit HoleWeights(const HoleBorder& border) {
    for (const Vec3& p : border.points) points_.emplace_back(p.x(), p.y(), p.z());
    for (const Vec3& p : border.across) across_.emplace_back(p.x(), p.y(), p.z());
  }

  /// Combines the subpolygons `left`, from i to m, and `right`, from m to k, with the triangle (i,
  /// m, k). Replaces `best` if the result is better, or equally good with a lower apex. Cheap tests
  /// come first.
  void improve(std::size_t i, std::size_t m, std::size_t k, const HoleSubpolygon& left,
               const HoleSubpolygon& right, HoleSubpolygon& best) const {
    HoleWeight weight{std::max(left.weight.angle, right.weight.angle),
                      left.weight.area + right.weight.area};
    weight.area += std::sqrt(CGAL::squared_area(points_[i], points_[m], points_[k]));
    const auto is_worse = [&] {
      return m < best.apex ? best.weight < weight : !(weight < best.weight);
    };
    if (is_worse()) return;
    weight.angle = std::max(weight.angle, angle(i, m, k, beyond(i, left)));
    if (is_worse()) return;
    weight.angle = std::max(weight.angle, angle(m, k, i, beyond(m, right)));
    if (i == 0 && k + 1 == points_.size())
      weight.angle = std::max(weight.angle, angle(k, i, m, across_[k]));
    if (is_worse() || CGAL::collinear(points_[i], points_[m], points_[k])) return;
    best = {weight, static_cast<Index>(m)};
  }

 private:
  const Point& beyond(std::size_t from, const HoleSubpolygon& subpolygon) const {
    return subpolygon.apex == no_index ? across_[from] : points_[subpolygon.apex];
  }
  double angle(std::size_t i, std::size_t k, std::size_t corner, const Point& beyond) const {
    return 180 - std::abs(CGAL::approximate_dihedral_angle(points_[i], points_[k], points_[corner],
                                                           beyond));
  }

  std::vector<Point> points_, across_;
};

/// Returns the triangles of a polygon of `size` points. The triangle at the edge (i, k), on the
/// side of the points between i and k, has the third corner apex(i, k).
template <class Apex>
std::vector<HoleTriangle> triangles_below(std::size_t size, const Apex& apex) {
  std::vector<HoleTriangle> triangles;
  std::vector<std::pair<Index, Index>> waiting{{0, static_cast<Index>(size - 1)}};
  while (!waiting.empty()) {
    const auto [i, k] = waiting.back();
    waiting.pop_back();
    if (i + 1 == k) continue;
    const Index m = apex(i, k);
    triangles.push_back({i, m, k});
    waiting.emplace_back(i, m);
    waiting.emplace_back(m, k);
  }
  std::reverse(triangles.begin(), triangles.end());
  return triangles;
}

}  // namespace transformesh

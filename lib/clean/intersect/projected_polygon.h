/// A closed polygon in space and its projection along an axis, with a test whether the projection
/// is simple.
#pragma once

#include <span>
#include <vector>

#include "geometry/numbers/predicates.h"

namespace transformesh {

class ProjectedPolygon {
 public:
  explicit ProjectedPolygon(std::span<const Vec3> points) : points_(points) {}

  void clear() { edges_.clear(); }
  void add(Index from, Index to) { edges_.push_back({from, to, 0, 0, 0, 0}); }
  std::size_t size() const { return edges_.size(); }

  /// True if the projected polygon is simple: two edges have no common point, except the common end
  /// of consecutive edges. The edges must form one cycle, and no edge may be projected to a point.
  /// If the result is true, the polygon is simple. The result is also false if the sweep exceeds
  /// its limit of steps. Cost: O(n log n).
  bool is_simple(PlaneProjection projection);

 private:
  struct Edge {
    Index from, to;
    double low, high;    ///< range along the sweep axis
    double bottom, top;  ///< range along the other axis
  };

  void measure();
  bool are_apart(const Edge& e, const Edge& f) const;
  bool goes_on(const Vec3& a, const Vec3& b, const Vec3& c) const;

  std::span<const Vec3> points_;
  PlaneProjection projection_;
  std::vector<Edge> edges_;
  std::vector<Edge> open_;  ///< edges that overlap the current position of the sweep
};

}  // namespace transformesh

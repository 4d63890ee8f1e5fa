/// Whether a closed polygon, seen along an axis, is simple.
#pragma once

#include <span>
#include <vector>

#include "geometry/numbers/predicates.h"

namespace transformesh {

class ProjectedOutline {
 public:
  explicit ProjectedOutline(std::span<const Vec3> points) : points_(points) {}

  void clear() { edges_.clear(); }
  void add(Index from, Index to) { edges_.push_back({from, to, 0, 0, 0, 0}); }
  std::size_t size() const { return edges_.size(); }

  /// Whether the edges, which go around once and none of which is projected to a point, have
  /// nothing in common but the ends at which one follows the other. A positive answer is certain;
  /// if very many edges lie side by side, a simple outline may not be recognized. O(n log n).
  bool is_simple(PlaneProjection projection);

 private:
  struct Edge {
    Index from, to;
    double low, high;    ///< along the axis that is swept
    double bottom, top;  ///< along the other one
  };

  void measure();
  bool are_apart(const Edge& e, const Edge& f) const;
  bool goes_on(const Vec3& a, const Vec3& b, const Vec3& c) const;

  std::span<const Vec3> points_;
  PlaneProjection projection_;
  std::vector<Edge> edges_;
  std::vector<Edge> open_;  ///< those that the sweep has reached and not yet passed
};

}  // namespace transformesh

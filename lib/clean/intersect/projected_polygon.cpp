#include "clean/intersect/projected_polygon.h"

#include <algorithm>
#include <tuple>

namespace transformesh {
namespace {

/// Limit on the number of steps of the sweep, divided by the number of edges. If it is exceeded,
/// the polygon is not accepted. A choice: a higher limit accepts outlines with more edges side by
/// side, and takes longer.
constexpr std::size_t most_steps = 64;

}  // namespace

// Computes the ranges of all edges along the axis of the sweep and across it. The sweep moves along
// the longer side of the projected bounding box.
void ProjectedPolygon::measure() {
  Vec3 low = points_[edges_[0].from], high = low;
  for (const Edge& edge : edges_) {
    low = low.cwiseMin(points_[edge.from]);
    high = high.cwiseMax(points_[edge.from]);
  }
  const auto [u, v] = projection_;
  const bool is_wide = high[u] - low[u] >= high[v] - low[v];
  const int along = is_wide ? u : v, across = is_wide ? v : u;
  for (Edge& edge : edges_) {
    const Vec3 &a = points_[edge.from], &b = points_[edge.to];
    std::tie(edge.low, edge.high) = std::minmax(a[along], b[along]);
    std::tie(edge.bottom, edge.top) = std::minmax(a[across], b[across]);
  }
}

// True if b is between a and c. The projections of the three points must be collinear.
bool ProjectedPolygon::goes_on(const Vec3& a, const Vec3& b, const Vec3& c) const {
  const int axis = a[projection_.u] != b[projection_.u] ? projection_.u : projection_.v;
  return (a[axis] < b[axis]) == (b[axis] < c[axis]);
}

// True if the projected edges are disjoint, except for a common end of consecutive edges. Two
// disjoint segments that are not collinear are separated by the line through one of them.
bool ProjectedPolygon::are_apart(const Edge& e, const Edge& f) const {
  const Vec3 &a = points_[e.from], &b = points_[e.to], &c = points_[f.from], &d = points_[f.to];
  const auto side = [&](const Vec3& from, const Vec3& to, const Vec3& point) {
    return orient2d(from, to, point, projection_);
  };
  if (e.from == f.from || e.to == f.to || (e.to == f.from && f.to == e.from)) return false;
  if (e.to == f.from) return side(a, b, d) != 0 || goes_on(a, b, d);
  if (f.to == e.from) return side(c, d, b) != 0 || goes_on(c, d, b);
  return side(a, b, c) * side(a, b, d) > 0 || side(c, d, a) * side(c, d, b) > 0;
}

bool ProjectedPolygon::is_simple(PlaneProjection projection) {
  projection_ = projection;
  if (edges_.empty()) return false;
  measure();
  std::sort(edges_.begin(), edges_.end(),
            [](const Edge& e, const Edge& f) { return e.low < f.low; });
  open_.clear();
  std::size_t steps_left = most_steps * edges_.size();
  for (const Edge& edge : edges_) {
    if (steps_left < open_.size()) return false;
    steps_left -= open_.size();
    std::size_t kept = 0;
    for (const Edge& other : open_) {
      if (other.high < edge.low) continue;
      const bool may_touch = other.bottom <= edge.top && edge.bottom <= other.top;
      if (may_touch && !are_apart(edge, other)) return false;
      open_[kept++] = other;
    }
    open_.resize(kept);
    open_.push_back(edge);
  }
  return true;
}

}  // namespace transformesh

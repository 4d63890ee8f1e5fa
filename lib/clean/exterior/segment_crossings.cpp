#include "clean/exterior/segment_crossings.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace transformesh {

/// Side of a line on which a point is, with a lower and an upper bound of the distance from the
/// line.
struct SegmentCrossings::Height {
  int side;
  double least, most;

  /// Returns bounds of the fraction of a segment's length at which the segment crosses the line.
  /// The segment starts at the point of `*this` and ends at the point of `end`, on the other side
  /// of the line.
  std::array<double, 2> share_before(const Height& end) const {
    constexpr double rounding = 1e-15;  // exceeds the rounding error of the quotients
    return {least / (least + end.most) - rounding, most / (most + end.least) + rounding};
  }
};

// If the floating-point filter does not decide, tests the point against the plane of the face that
// intersects in the segment. This test costs less than an exact 2D orientation. The sign of `jump`
// tells which side of the segment is in front of the intersecting face.
int SegmentCrossings::side(Index s, const ExactPoint& of) const {
  const PlanarSegment& line = segment(s);
  const int sign =
      ExactGeometry::quick_orient2d(point(line.from), point(line.to), of, in_.projection);
  if (sign != 0) return sign;
  if (planes_.empty()) planes_.resize(in_.segments.size());
  std::optional<ExactPlane>& plane = planes_[s];
  if (!plane) plane = geometry_.plane(line.face);
  return line.jump * geometry_.orient3d(*plane, of);
}

Eigen::AlignedBox2d SegmentCrossings::box_of(const ExactPoint& from, const ExactPoint& to) const {
  Eigen::AlignedBox2d box;
  const std::array<int, 2> axes{in_.projection.u, in_.projection.v};
  for (std::size_t i = 0; i < 2; ++i) {
    const int axis = axes[i];
    box.min()[i] =
        std::min(from.center[axis] - from.radius[axis], to.center[axis] - to.radius[axis]);
    box.max()[i] =
        std::max(from.center[axis] + from.radius[axis], to.center[axis] + to.radius[axis]);
  }
  return box;
}

bool SegmentCrossings::find() {
  std::vector<Index> order(in_.segments.size());
  for (const PlanarSegment& s : in_.segments) boxes_.push_back(box_of(point(s.from), point(s.to)));
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return boxes_[a].min()[0] < boxes_[b].min()[0] ||
           (boxes_[a].min()[0] == boxes_[b].min()[0] && a < b);
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Eigen::AlignedBox2d& a = boxes_[order[i]];
    for (std::size_t k = i + 1; k < order.size() && boxes_[order[k]].min()[0] <= a.max()[0]; ++k) {
      if (!a.intersects(boxes_[order[k]])) continue;
      if (!add(order[i], order[k])) return false;
    }
  }
  file();
  return true;
}

// Adds the crossing of two segments, if they cross. Segments that share an end have no other common
// point, unless the common end is a corner.
bool SegmentCrossings::add(Index a, Index b) {
  const PlanarSegment &s = segment(a), &t = segment(b);
  if (s.from == t.from || s.from == t.to || s.to == t.from) return true;
  if (s.to == t.to) return !in_.is_corner(s.to) || side(a, point(t.from)) != 0;
  const Height from_b = height_over(a, t.from), to_b = height_over(a, t.to);
  if (from_b.side == to_b.side && from_b.side != 0) return true;
  const Height from_a = height_over(b, s.from), to_a = height_over(b, s.to);
  if (from_a.side == to_a.side && from_a.side != 0) return true;
  if (from_a.side * to_a.side == 0 || from_b.side * to_b.side == 0) return false;
  const auto [least_a, most_a] = from_a.share_before(to_a);
  const auto [least_b, most_b] = from_b.share_before(to_b);
  const auto pair = static_cast<Index>(found_.size() / 2);
  found_.push_back({a, b, pair, from_a.side, least_a, most_a});
  found_.push_back({b, a, pair, from_b.side, least_b, most_b});
  return true;
}

SegmentCrossings::Height SegmentCrossings::height_over(Index s, Index p) const {
  const BoundedNumber turn = ExactGeometry::bounded_orient2d(
      point(segment(s).from), point(segment(s).to), point(p), in_.projection);
  const double size = std::abs(turn.value);
  const int sign = turn.sign() != 0 ? turn.sign() : side(s, point(p));
  return {sign, std::max(size - turn.error, 0.0), size + turn.error};
}

// Returns the point of a crossing from a cache. The cache also keeps the more precise coordinates
// that exact tests compute for the point.
const ExactPoint& SegmentCrossings::point_of(const Crossing& crossing) const {
  const auto known = points_.find(crossing.pair);
  if (known != points_.end()) return known->second;
  const Index first = segment(crossing.segment).face, second = segment(crossing.other).face;
  return points_.emplace(crossing.pair, geometry_.three_planes(in_.face, first, second))
      .first->second;
}

// Returns the axis along which the projected segment is longest, and the sign of its direction.
SegmentCrossings::Direction SegmentCrossings::direction(Index s) const {
  const ExactPoint &from = point(segment(s).from), &to = point(segment(s).to);
  const Vec3 way = (to.center - from.center).cwiseAbs();
  const auto [u, v] = in_.projection;
  const int longer = way[u] < way[v] ? v : u;
  const int sign = geometry_.compare_coordinate(to, from, longer);
  if (sign != 0) return {longer, sign};
  const int other = u + v - longer;
  return {other, geometry_.compare_coordinate(to, from, other)};
}

// Compares two crossings along segment `s`: -1 if `a` is first, +1 if `b` is first, 0 if they are
// the same point.
int SegmentCrossings::order_along(Index s, const Crossing& a, const Crossing& b) const {
  if (a.most < b.least) return -1;
  if (b.most < a.least) return 1;
  const Direction along = direction(s);
  return along.sign * geometry_.compare_coordinate(point_of(a), point_of(b), along.axis);
}

// Groups the crossings by segment.
void SegmentCrossings::file() {
  first_.assign(in_.segments.size() + 1, 0);
  for (const Crossing& crossing : found_) ++first_[crossing.segment + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  std::vector<Index> next = first_;
  crossings_.resize(found_.size());
  for (const Crossing& crossing : found_) crossings_[next[crossing.segment]++] = crossing;
}

bool SegmentCrossings::sort_along(Index s) {
  bool is_decided = true;
  // Stable sorting terminates even if `order_along` is not a strict order.
  std::stable_sort(crossings_.begin() + first_[s], crossings_.begin() + first_[s + 1],
                   [&](const Crossing& a, const Crossing& b) {
                     const int order = order_along(s, a, b);
                     is_decided = is_decided && order != 0;
                     return order < 0;
                   });
  return is_decided;
}

std::optional<int> SegmentCrossings::change_before(const Crossing& crossing) const {
  int change = 0;
  for (const Crossing& earlier : of(crossing.segment)) {
    if (earlier.other == crossing.other) continue;
    const int order = order_along(crossing.segment, earlier, crossing);
    if (order == 0) return std::nullopt;
    if (order < 0) change += jump_over(earlier);
  }
  return change;
}

}  // namespace transformesh

#include "clean/exterior/bounding_subsegments.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/corners.h"

namespace transformesh {
namespace {

constexpr int unknown_left = std::numeric_limits<int>::min();

class BoundingSubsegments {
 public:
  BoundingSubsegments(const ExactGeometry& geometry, const SegmentsInFace& in,
                      const std::vector<KnownWinding>& known)
      : geometry_(geometry),
        in_(in),
        known_(known),
        crossings_(geometry, in),
        left_(in.segments.size(), unknown_left) {}

  // Each of these functions returns false if it fails, so that the face has to be cut along all
  // segments.
  bool join_ends();
  bool find_crossings() { return crossings_.find(); }
  bool find_windings();
  bool find_subsegments(int front, std::vector<Subsegment>& parts);

 private:
  const PlanarSegment& segment(Index s) const { return in_.segments[s]; }
  const ExactPoint& point(Index p) const { return in_.points[p]; }
  int side(Index s, const ExactPoint& of) const { return crossings_.side(s, of); }
  Index partner_at(Index p, Index s) const {
    return at_point_[p][0] == s ? at_point_[p][1] : at_point_[p][0];
  }
  bool may_reach(Index s, int front) const;
  std::optional<int> winding_beside(Index s) const;
  std::optional<int> winding_at_edge(Index p, const KnownWinding& known) const;
  std::optional<int> winding_at(Index p, const KnownWinding& known) const;
  bool is_on_left(Index s, Index partner, const ExactPoint& seen_from) const;
  bool spread(Index seed, int w);
  bool continue_at(Index p, Index s, int left);
  bool spread_over(const Crossing& crossing);
  bool visit(Index s, int left);

  const ExactGeometry& geometry_;
  const SegmentsInFace& in_;
  const std::vector<KnownWinding>& known_;
  SegmentCrossings crossings_;
  /// The segments, at most two, of which each point is an end; no_index if there are fewer.
  std::vector<std::array<Index, 2>> at_point_;
  /// Winding number w in front of the face, just to the left of the start of each segment.
  std::vector<int> left_;
  std::vector<Index> stack_;
};

// Joins segments that share an end to curves. Returns true if the curves end only at edges and
// corners of the face, and no point is the end of three segments.
bool BoundingSubsegments::join_ends() {
  at_point_.assign(in_.points.size(), {no_index, no_index});
  for (Index s = 0; s < in_.segments.size(); ++s) {
    for (const Index p : {segment(s).from, segment(s).to}) {
      if (in_.is_corner(p)) continue;
      auto& [first, second] = at_point_[p];
      if (second != no_index) return false;
      (first == no_index ? first : second) = s;
    }
  }
  for (Index p = 0; p < at_point_.size(); ++p)
    if ((at_point_[p][1] == no_index) != (in_.edge_of[p] != no_index)) return false;
  return true;
}

bool BoundingSubsegments::find_windings() {
  for (Index s = 0; s < in_.segments.size(); ++s) {
    if (left_[s] != unknown_left) continue;
    const std::optional<int> w = winding_beside(s);
    if (w && !spread(s, *w)) return false;
  }
  return std::find(left_.begin(), left_.end(), unknown_left) == left_.end();
}

// Returns the winding number w just to the left of the start of segment `s`. Follows a path from
// one of the points of the face at which w is known.
std::optional<int> BoundingSubsegments::winding_beside(Index s) const {
  const Index start = segment(s).from, edge = in_.edge_of[start];
  const Index partner = partner_at(start, s);
  for (const KnownWinding& known : known_) {
    if (side(s, known.at) == 0 || (partner != no_index && side(partner, known.at) == 0)) continue;
    const bool is_at_edge =
        edge != no_index && known.corner != no_index && known.corner != previous_corner(edge);
    const std::optional<int> w =
        is_at_edge ? winding_at_edge(start, known) : winding_at(start, known);
    if (w) return is_on_left(s, partner, known.at) ? *w : *w - segment(s).jump;
  }
  return std::nullopt;
}

// Returns the winding number w next to a point `p` on an edge of the face. Starts with the known
// value at a corner of this edge, and follows the edge. Adds the jumps of the segments that end on
// the edge between the corner and `p`.
std::optional<int> BoundingSubsegments::winding_at_edge(Index p, const KnownWinding& known) const {
  const ExactPoint& from = known.at;
  const auto distance = [&](int axis) {
    return std::abs(point(p).center[axis] - from.center[axis]);
  };
  const auto [u, v] = in_.projection;
  const int axis = distance(u) > distance(v) ? u : v;
  const int along = geometry_.compare_coordinate(point(p), from, axis);
  if (along == 0) return std::nullopt;
  int w = known.w;
  for (Index q = 0; q < in_.points.size(); ++q) {
    if (q == p || in_.edge_of[q] != in_.edge_of[p] || in_.is_corner(q)) continue;
    const int order = geometry_.compare_coordinate(point(q), point(p), axis) * along;
    if (order == 0) return std::nullopt;
    if (order > 0) continue;
    const Index s = at_point_[q][0];
    w += side(s, from) > 0 ? segment(s).jump : -segment(s).jump;
  }
  return w;
}

// Returns the winding number w at the end of the straight line from the known point to `p`. Starts
// with the known value, and adds the jumps of the segments that the line crosses.
std::optional<int> BoundingSubsegments::winding_at(Index p, const KnownWinding& known) const {
  const ExactPoint &from = known.at, &to = point(p);
  const Eigen::AlignedBox2d box = crossings_.box_of(from, to);
  int w = known.w;
  for (Index s = 0; s < in_.segments.size(); ++s) {
    const PlanarSegment& other = segment(s);
    if (other.from == p || other.to == p || !box.intersects(crossings_.box(s))) continue;
    const int a = geometry_.orient2d(from, to, point(other.from), in_.projection);
    const int b = geometry_.orient2d(from, to, point(other.to), in_.projection);
    if (a == b && a != 0) continue;
    const int start = side(s, from), end = side(s, to);
    if (start == end && start != 0) continue;
    if (a == 0 || b == 0 || start == 0 || end == 0) return std::nullopt;
    w += start > 0 ? other.jump : -other.jump;
  }
  return w;
}

// True if the straight line from `seen_from` to the start of segment `s` arrives on the left of
// `s`. If a segment `partner` ends at the same point, the left of `s` is the sector from `s`
// counter-clockwise to `partner`.
bool BoundingSubsegments::is_on_left(Index s, Index partner, const ExactPoint& seen_from) const {
  const bool is_left = side(s, seen_from) > 0;
  if (partner == no_index) return is_left;
  const Index start = segment(s).from;
  const bool leaves = segment(partner).from == start;
  const ExactPoint& end = point(leaves ? segment(partner).to : segment(partner).from);
  const bool is_left_of_partner = (side(partner, seen_from) > 0) == leaves;
  const int turn = side(s, end);
  if (turn == 0) return is_left;
  return turn > 0 ? is_left && !is_left_of_partner : is_left || !is_left_of_partner;
}

// Propagates the winding number w from segment `seed` along its curve of joined segments, and to
// the curves that cross this curve. `w` is the value to the left of the start of `seed`. Returns
// false on a contradiction.
bool BoundingSubsegments::spread(Index seed, int w) {
  if (!visit(seed, w)) return false;
  while (!stack_.empty()) {
    const Index s = stack_.back();
    stack_.pop_back();
    int w_at_end = left_[s];
    for (const Crossing& crossing : crossings_.of(s)) {
      w_at_end += crossings_.jump_over(crossing);
      if (left_[crossing.other] == unknown_left && !spread_over(crossing)) return false;
    }
    if (!continue_at(segment(s).from, s, left_[s]) || !continue_at(segment(s).to, s, w_at_end))
      return false;
  }
  return true;
}

// Propagates the winding number w to the segment that shares the end `p` with segment `s`. `left`
// is the value of w to the left of `s` at `p`. Returns false on a contradiction.
bool BoundingSubsegments::continue_at(Index p, Index s, int left) {
  const Index next = partner_at(p, s);
  if (next == no_index) return true;
  const bool is_turned = (segment(next).from == p) == (segment(s).from == p);
  if (segment(next).jump != (is_turned ? -segment(s).jump : segment(s).jump)) return false;
  int there = is_turned ? left - segment(next).jump : left;
  if (segment(next).from != p)
    for (const Crossing& crossing : crossings_.of(next)) there -= crossings_.jump_over(crossing);
  return visit(next, there);
}

// Propagates the winding number w from `crossing.segment` to the segment that crosses it. Returns
// false if this is not possible.
bool BoundingSubsegments::spread_over(const Crossing& crossing) {
  const Index s = crossing.segment, other = crossing.other;
  const auto there = crossings_.of(other);
  const auto back =
      std::find_if(there.begin(), there.end(), [&](const Crossing& c) { return c.other == s; });
  const std::optional<int> here = crossings_.change_before(crossing),
                           beyond = crossings_.change_before(*back);
  if (!here || !beyond) return false;
  int w = left_[s] + *here;  // w to the left of s, just before s crosses `other`
  if (crossing.side < 0) w -= segment(other).jump;  // w to the left of both segments
  // After this line, `w` is the value to the left of `other`, just before `other` crosses s.
  if (back->side < 0) w += segment(s).jump;
  return visit(other, w - *beyond);
}

bool BoundingSubsegments::visit(Index s, int left) {
  if (left_[s] != unknown_left) return left_[s] == left;
  left_[s] = left;
  stack_.push_back(s);
  return true;
}

// True if the winding number w in front of the face may be equal to `front` on either side of some
// part of the segment. Uses bounds that do not depend on the order of the crossings.
bool BoundingSubsegments::may_reach(Index s, int front) const {
  int least = left_[s], most = left_[s];
  for (const Crossing& crossing : crossings_.of(s)) {
    const int jump = crossings_.jump_over(crossing);
    (jump < 0 ? least : most) += jump;
  }
  (segment(s).jump < 0 ? least : most) += segment(s).jump;
  return least <= front && front <= most;
}

// Lists the parts of segments with exterior on exactly one side. `front` is the winding number w in
// front of the exterior.
bool BoundingSubsegments::find_subsegments(int front, std::vector<Subsegment>& parts) {
  for (Index s = 0; s < in_.segments.size(); ++s) {
    if (!may_reach(s, front)) continue;
    if (!crossings_.sort_along(s)) return false;
    int left = left_[s];
    Index from = no_index;
    const auto end_subsegment = [&](Index to) {
      const bool is_left = left == front, is_right = left + segment(s).jump == front;
      if (is_left != is_right) parts.push_back({s, from, to, is_left});
    };
    for (const Crossing& crossing : crossings_.of(s)) {
      end_subsegment(crossing.other);
      from = crossing.other;
      left += crossings_.jump_over(crossing);
    }
    end_subsegment(no_index);
  }
  return true;
}

}  // namespace

std::optional<std::vector<Subsegment>> find_bounding_subsegments(
    const ExactGeometry& geometry, const SegmentsInFace& in, const std::vector<KnownWinding>& known,
    int winding_level) {
  BoundingSubsegments bounding(geometry, in, known);
  if (!bounding.join_ends() || !bounding.find_crossings()) return std::nullopt;
  std::vector<Subsegment> parts;
  if (!bounding.find_windings() || !bounding.find_subsegments(winding_level - 1, parts))
    return std::nullopt;
  return parts;
}

}  // namespace transformesh

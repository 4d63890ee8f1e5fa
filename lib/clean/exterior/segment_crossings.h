/// Where segments in a face cross each other, and in which order along each. Exact; deterministic.
/// Cost: O(s log s + p) for s segments of which p pairs have boxes that overlap.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "geometry/numbers/exact_point.h"

namespace transformesh {

/// Where another face crosses the face.
struct PlanarSegment {
  Index from, to;  ///< points; only the second may be a corner of the face
  Index face;      ///< the one that crosses
  int jump;  ///< by how much w in front grows from left to right: +1 or -1, so that its left is
             ///< in front of the face that crosses, or behind it
};

/// The segments in a face.
struct SegmentsInFace {
  Index face = no_index;
  PlaneProjection projection;      ///< in which it turns counter-clockwise
  std::vector<ExactPoint> points;  ///< the segments' ends
  std::vector<Index> edge_of;      ///< per point: an edge of the face on which it is, or no_index
  std::vector<PlanarSegment> segments;

  bool is_corner(Index p) const {
    return points[p].definition.kind == PointDefinition::Kind::given;
  }
};

/// Where one segment crosses another.
struct Crossing {
  Index segment, other;
  Index pair;          ///< a number that both segments' crossings have in common
  int side;            ///< of the other on which the segment starts: +1 for its left
  double least, most;  ///< bounds for where that is on the segment, as a share of its length
};

class SegmentCrossings {
 public:
  /// Keeps references.
  SegmentCrossings(const ExactGeometry& geometry, const SegmentsInFace& in)
      : geometry_(geometry), in_(in) {}

  /// Returns whether segments merely cross: they do not touch, but in common ends.
  bool find();
  /// The crossings of a segment, in any order, or along it once it is sorted.
  std::span<const Crossing> of(Index s) const {
    return {crossings_.data() + first_[s], crossings_.data() + first_[s + 1]};
  }
  /// Returns whether that is possible: no three segments meet in one point of it.
  bool sort_along(Index s);
  /// By how much w in front grows along the segment over a crossing.
  int jump_over(const Crossing& crossing) const {
    const int jump = in_.segments[crossing.other].jump;
    return crossing.side > 0 ? jump : -jump;
  }
  /// By how much from the start of its segment to just before it. Nothing where another segment
  /// crosses there as well.
  std::optional<int> change_before(const Crossing& crossing) const;

  /// +1 for what is left of a segment.
  int side(Index s, const ExactPoint& of) const;
  Eigen::AlignedBox2d box_of(const ExactPoint& from, const ExactPoint& to) const;
  const Eigen::AlignedBox2d& box(Index s) const { return boxes_[s]; }

 private:
  struct Height;
  struct Direction {
    int axis, sign;
  };

  const PlanarSegment& segment(Index s) const { return in_.segments[s]; }
  const ExactPoint& point(Index p) const { return in_.points[p]; }
  bool add(Index a, Index b);
  void file();
  Height height_over(Index s, Index p) const;
  Direction direction(Index s) const;
  int order_along(Index s, const Crossing& a, const Crossing& b) const;
  const ExactPoint& point_of(const Crossing& crossing) const;

  const ExactGeometry& geometry_;
  const SegmentsInFace& in_;
  std::vector<Eigen::AlignedBox2d> boxes_;   ///< per segment
  std::vector<Crossing> found_, crossings_;  ///< as found, and by segments
  std::vector<Index> first_;
  mutable std::vector<std::optional<ExactPlane>> planes_;  ///< that cross, where they were needed
  mutable std::unordered_map<Index, ExactPoint> points_;   ///< per pair, where it was needed
};

}  // namespace transformesh

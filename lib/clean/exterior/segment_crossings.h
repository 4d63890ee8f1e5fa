/// Finds the crossings of the segments in which other faces intersect a face, and the order of the
/// crossings along each segment. Exact; deterministic. Cost: O(s log s + p) for s segments of which
/// p pairs have overlapping boxes, if few segments overlap along one axis.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "geometry/numbers/exact_point.h"

namespace transformesh {

/// The segment in which another face intersects the face that is cut.
struct PlanarSegment {
  Index from, to;  ///< indices of its ends in `points`; only `to` may be a corner of the face
  Index face;      ///< the intersecting face
  /// Increase of the winding number in front of the face, from the left to the right of the
  /// segment: +1 or -1. If it is +1, the left side is in front of the intersecting face, otherwise
  /// behind it.
  int jump;
};

/// The segments in which other faces intersect a face.
struct SegmentsInFace {
  Index face = no_index;
  PlaneProjection projection;      ///< projection in which the face is counter-clockwise
  std::vector<ExactPoint> points;  ///< ends of the segments
  /// For each point the edge of the face (0 to 2) that contains the point, or no_index.
  std::vector<Index> edge_of;
  std::vector<PlanarSegment> segments;

  bool is_corner(Index p) const {
    return points[p].definition.kind == PointDefinition::Kind::given;
  }
};

/// An intersection of two segments. It is stored twice, once with each of the two as `segment`.
struct Crossing {
  Index segment, other;
  Index pair;  ///< number of the crossing, equal in both of its entries
  int side;    ///< side of `other` on which the start of `segment` is: +1 for left
  /// Lower and upper bound of the position of the crossing on `segment`, as a fraction of its
  /// length.
  double least, most;
};

class SegmentCrossings {
 public:
  /// Keeps references to both arguments.
  SegmentCrossings(const ExactGeometry& geometry, const SegmentsInFace& in)
      : geometry_(geometry), in_(in) {}

  /// Finds all crossings. Returns false if segments touch elsewhere than at common ends.
  bool find();
  /// Returns the crossings of a segment; after sort_along() in their order along the segment.
  std::span<const Crossing> of(Index s) const {
    return {crossings_.data() + first_[s], crossings_.data() + first_[s + 1]};
  }
  /// Sorts the crossings of a segment along the segment. Returns false if three segments meet in
  /// one point of it.
  bool sort_along(Index s);
  /// Returns by how much the winding number w in front of the face increases along
  /// `crossing.segment` at the crossing.
  int jump_over(const Crossing& crossing) const {
    const int jump = in_.segments[crossing.other].jump;
    return crossing.side > 0 ? jump : -jump;
  }
  /// Returns by how much the winding number w in front of the face increases along
  /// `crossing.segment` from its start to just before the crossing. Returns nothing if a third
  /// segment crosses at the same point.
  std::optional<int> change_before(const Crossing& crossing) const;

  /// Returns the side of a segment on which a point is: +1 for left, -1 for right, 0 for the line
  /// through the segment.
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
  std::vector<Eigen::AlignedBox2d> boxes_;  ///< projected box of each segment
  /// `found_` has the crossings in the order of detection, `crossings_` has them sorted by segment.
  std::vector<Crossing> found_, crossings_;
  std::vector<Index> first_;
  /// Planes of the intersecting faces, each computed on demand.
  mutable std::vector<std::optional<ExactPlane>> planes_;
  /// The point of each Crossing::pair, computed on demand.
  mutable std::unordered_map<Index, ExactPoint> points_;
};

}  // namespace transformesh

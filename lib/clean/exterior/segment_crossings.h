/// Finds the crossings of segments in a face, and their order along each segment. Exact;
/// deterministic. Cost: O(s log s + p) for s segments of which p pairs have overlapping boxes, if
/// few segments overlap along one axis.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "geometry/numbers/exact_point.h"

namespace transformesh {

/// The segment in which another face intersects the face.
struct PlanarSegment {
  Index from, to;  ///< indices of its ends in `points`; only `to` may be a corner of the face
  Index face;      ///< the intersecting face
  /// Increase of the winding number in front of the face, from left to right of the segment: +1 or
  /// -1. The sign determines whether the left side is in front of the intersecting face or behind
  /// it.
  int jump;
};

/// All segments in a face.
struct SegmentsInFace {
  Index face = no_index;
  PlaneProjection projection;      ///< projection in which the face is counter-clockwise
  std::vector<ExactPoint> points;  ///< ends of the segments
  /// For each point the edge of the face that contains it, or no_index.
  std::vector<Index> edge_of;
  std::vector<PlanarSegment> segments;

  bool is_corner(Index p) const {
    return points[p].definition.kind == PointDefinition::Kind::given;
  }
};

/// An intersection of two segments.
struct Crossing {
  Index segment, other;
  Index pair;  ///< number that both segments' entries of the crossing share
  int side;    ///< side of `other` at which `segment` starts: +1 for left
  /// Bounds of the crossing's position on `segment`, as a fraction of its length.
  double least, most;
};

class SegmentCrossings {
 public:
  /// Keeps references to both arguments.
  SegmentCrossings(const ExactGeometry& geometry, const SegmentsInFace& in)
      : geometry_(geometry), in_(in) {}

  /// Finds all crossings. Returns false if segments touch elsewhere than at common ends.
  bool find();
  /// Returns the crossings of a segment, in order along it after sort_along().
  std::span<const Crossing> of(Index s) const {
    return {crossings_.data() + first_[s], crossings_.data() + first_[s + 1]};
  }
  /// Sorts the crossings of a segment. Returns false if three segments meet in one of its points.
  bool sort_along(Index s);
  /// Returns the increase of the winding number w in front along the segment at a crossing.
  int jump_over(const Crossing& crossing) const {
    const int jump = in_.segments[crossing.other].jump;
    return crossing.side > 0 ? jump : -jump;
  }
  /// Returns the increase of the winding number w in front from the start of the segment to just
  /// before a crossing. Returns nothing if another segment crosses at the same point.
  std::optional<int> change_before(const Crossing& crossing) const;

  /// Returns the side of a segment on which a point is: +1 for left.
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
  /// Crossings in order of detection; crossings sorted by segment.
  std::vector<Crossing> found_, crossings_;
  std::vector<Index> first_;
  /// Planes of the intersecting faces, each computed on demand.
  mutable std::vector<std::optional<ExactPlane>> planes_;
  /// The point of each Crossing::pair, computed on demand.
  mutable std::unordered_map<Index, ExactPoint> points_;
};

}  // namespace transformesh

/// Change of the winding number of a closed oriented mesh along a path parallel to the axes. Faces
/// are added one by one, in any order, so that they can come from a stream. Exact predicates decide
/// whether the path crosses a face. Deterministic; O(1) per face.
#pragma once

#include <optional>
#include <utility>

#include "mesh/triangle.h"

namespace transformesh {

/// A path from one point to another: along x, then along y, then along z.
class AxisPath {
 public:
  /// Coordinates of `to` may be infinite if the coordinates of `from` are finite.
  AxisPath(Vec3 from, Vec3 to) : from_(std::move(from)), to_(std::move(to)) {}

  /// Adds a face. Faces without area are ignored.
  void add(const Triangle& triangle);
  /// Returns the winding number at the end minus that at the start. Returns nothing if the path
  /// meets an edge or a corner, or if a bend or an end of the path is on a face.
  std::optional<int> change() const { return is_certain_ ? std::optional(change_) : std::nullopt; }

 private:
  void cross(const Triangle& triangle, const Vec3& start, int axis);

  Vec3 from_, to_;
  int change_ = 0;
  bool is_certain_ = true;
};

/// Returns point i of a quasirandom sequence that fills a box evenly. No two points share a
/// coordinate, unless the box is only a few coordinate spacings wide. Reference: Roberts, "The
/// unreasonable effectiveness of quasirandom sequences", 2018 (R3).
Vec3 spread_point(const Eigen::AlignedBox3d& box, int i);

}  // namespace transformesh

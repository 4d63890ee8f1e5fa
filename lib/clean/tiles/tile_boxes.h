/// Divides space into boxes that contain about equally many points, and finds the boxes that touch
/// a box. Deterministic.
#pragma once

#include <functional>
#include <vector>

#include "transformesh/measure.h"

namespace transformesh {

/// Returns `count` half-open boxes that cover space without overlap. They are the leaves of a k-d
/// tree, whose nodes are split along the longest side of the bounding box of their points. Boxes
/// may contain no points if many points share a coordinate. O(n log count).
std::vector<Box> divide_space(std::vector<Vec3> points, std::size_t count);

/// Uniform grid for finding the boxes that touch a box. Cost: O(boxes) to build; about O(1) per
/// query if the boxes are tiles.
class BoxGrid {
 public:
  /// The grid divides `bounds`. The boxes may extend beyond `bounds`, even to infinity.
  BoxGrid(const Box& bounds, std::vector<Box> boxes);

  const std::vector<Box>& boxes() const { return boxes_; }
  /// Stores in `found` the indices of the boxes that touch the box from `low` to `high`, ascending.
  void find(const Vec3& low, const Vec3& high, std::vector<Index>& found) const;

 private:
  std::array<int, 3> cell_of(const Vec3& point) const;

  Box bounds_;
  std::vector<Box> boxes_;
  std::vector<std::vector<Index>> cells_;
};

}  // namespace transformesh

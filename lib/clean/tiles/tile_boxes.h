/// Division of space into boxes that hold about equally many points. Deterministic.
#pragma once

#include <functional>
#include <vector>

#include "transformesh/measure.h"

namespace transformesh {

/// Returns `count` half-open boxes that cover space and do not overlap. They are the leaves of a
/// k-d tree, split along the longest side of its points. A box has no points if many points share a
/// coordinate. O(n log count).
std::vector<Box> divide_space(std::vector<Vec3> points, std::size_t count);

/// Boxes, found by what touches them. Cost: O(boxes) to build, about O(1) to search if boxes are
/// tiles.
class BoxGrid {
 public:
  /// Cells divide `bounds`; boxes may reach farther, without end.
  BoxGrid(const Box& bounds, std::vector<Box> boxes);

  const std::vector<Box>& boxes() const { return boxes_; }
  /// Appends the indices of the boxes that touch the box from `low` to `high` to a list that it
  /// clears. Ascending.
  void find(const Vec3& low, const Vec3& high, std::vector<Index>& found) const;

 private:
  std::array<int, 3> cell_of(const Vec3& point) const;

  Box bounds_;
  std::vector<Box> boxes_;
  std::vector<std::vector<Index>> cells_;
};

}  // namespace transformesh

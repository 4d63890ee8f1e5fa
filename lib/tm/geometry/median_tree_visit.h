/// The nearest query of MedianTree, for the sources that use it.
#pragma once

#include <algorithm>

#include "tm/geometry/median_tree.h"

namespace transformesh {

inline double MedianTree::squared_distance(std::size_t node, const Vec3& query) const {
  const FloatBox& box = nodes_[node];
  const auto outside = [&](std::size_t axis) {
    const double coordinate = query.data()[axis];
    return std::max({box.minimum[axis] - coordinate, coordinate - box.maximum[axis], 0.0});
  };
  return squared_length(outside(0), outside(1), outside(2));
}

template <class Bound, class Visit>
void MedianTree::visit_nearest(const Vec3& query, const Bound& bound, const Visit& visit) const {
  if (order_.empty()) return;
  std::array<Cell, 64> stack;  // deeper than any tree, as every cut halves
  std::size_t waiting = 0;
  stack[waiting++] = {0, order_.size(), 0, 0};
  while (waiting > 0) {
    // Down the nearer half of each cell; the other half waits.
    Cell cell = stack[--waiting];
    while (cell.distance <= bound() && cell.last - cell.first > bucket_size_) {
      const std::size_t child = 2 * cell.node + 1;
      const Cell left{cell.first, cell.middle(), child, squared_distance(child, query)};
      const Cell right{cell.middle(), cell.last, child + 1, squared_distance(child + 1, query)};
      const bool is_left_nearer = left.distance <= right.distance;
      stack[waiting] = is_left_nearer ? right : left;
      if (stack[waiting].distance <= bound()) ++waiting;
      cell = is_left_nearer ? left : right;
    }
    if (!(cell.distance <= bound())) continue;
    for (std::size_t place = cell.first; place < cell.last; ++place) visit(place);
  }
}

}  // namespace transformesh

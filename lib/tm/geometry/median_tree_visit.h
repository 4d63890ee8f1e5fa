/// The nearest query of MedianTree, for the sources that use it.
#pragma once

#include <algorithm>

#include "tm/geometry/median_tree.h"

namespace transformesh {

inline Eigen::Array2d MedianTree::Halves::squared_distances(const Vec3& query) const {
  const auto outside = [&](std::size_t axis) -> Eigen::Array2d {
    const Eigen::Array2d low(minimum[axis][0], minimum[axis][1]);
    const Eigen::Array2d high(maximum[axis][0], maximum[axis][1]);
    const double coordinate = query.data()[axis];
    return (low - coordinate).max(coordinate - high).max(0.0);
  };
  const Eigen::Array2d x = outside(0);
  const Eigen::Array2d y = outside(1);
  const Eigen::Array2d z = outside(2);
  return x * x + y * y + z * z;
}

template <class Bound, class Visit>
void MedianTree::visit_nearest(const Vec3& query, const Bound& bound, const Visit& visit) const {
  if (order_.empty()) return;
  std::array<Cell, 64> stack;  // deeper than any tree, as every cut halves a cell
  std::size_t waiting = 0;
  stack[waiting++] = {0, order_.size(), 0, 0};
  while (waiting > 0) {
    // The search goes down the nearer half of each cell, while the other half waits.
    Cell cell = stack[--waiting];
    while (cell.distance <= bound() && cell.last - cell.first > bucket_size_) {
      const std::size_t child = 2 * cell.node + 1;
      const Eigen::Array2d squares = nodes_[cell.node].squared_distances(query);
      const Cell left{cell.first, cell.middle(), child, squares[0]};
      const Cell right{cell.middle(), cell.last, child + 1, squares[1]};
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

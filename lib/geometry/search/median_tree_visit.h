/// Definition of the nearest-neighbor query of MedianTree, a template, for source files that call
/// it.
#pragma once

#include <algorithm>

#include "geometry/search/median_tree.h"

namespace transformesh {

inline std::array<double, 2> MedianTree::Halves::squared_distances(const Vec3& query) const {
  using Pair [[gnu::vector_size(16)]] = double;  // one entry per half, for vector instructions
  const auto larger = [](Pair a, Pair b) { return a > b ? a : b; };
  const auto outside = [&](std::size_t axis) {
    const Pair low = {minimum[axis][0], minimum[axis][1]};
    const Pair high = {maximum[axis][0], maximum[axis][1]};
    const double coordinate = query.data()[axis];
    return larger(larger(low - coordinate, coordinate - high), Pair{});
  };
  const Pair x = outside(0);
  const Pair y = outside(1);
  const Pair z = outside(2);
  const Pair squares = x * x + y * y + z * z;
  return {squares[0], squares[1]};
}

template <class Bound, class Visit>
void MedianTree::visit_nearest(const Vec3& query, const Bound& bound, const Visit& visit) const {
  if (order_.empty()) return;
  std::array<Cell, 64> stack;  // exceeds the depth of any tree, because each cut halves a cell
  std::size_t waiting = 0;
  stack[waiting++] = {0, order_.size(), 0, 0};
  while (waiting > 0) {
    // Descend into the nearer half of each cell, and push the other half.
    Cell cell = stack[--waiting];
    while (cell.distance <= bound() && cell.last - cell.first > bucket_size_) {
      const std::size_t child = 2 * cell.node + 1;
      const auto [left_square, right_square] = nodes_[cell.node].squared_distances(query);
      const Cell left{cell.first, cell.middle(), child, left_square};
      const Cell right{cell.middle(), cell.last, child + 1, right_square};
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

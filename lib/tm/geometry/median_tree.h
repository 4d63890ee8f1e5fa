/// A binary tree of boxes for nearest queries: every cell is cut at the median of its widest axis,
/// with a tight box around each half. It takes longer to build than the Bvh, whose boxes overlap
/// more, and answers nearest queries several times faster. Depth and cells depend on the number of
/// boxes alone. Cost: O(n log n) on all allowed threads; deterministic.
/// Reference: Friedman, Bentley & Finkel, "An algorithm for finding best matches in logarithmic
/// expected time", TOMS 3(3), 1977.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "tm/geometry/float_box.h"

namespace transformesh {

class MedianTree {
 public:
  /// Cells of at most `bucket_size` boxes are not cut.
  MedianTree(std::span<const FloatBox> boxes, std::size_t bucket_size);

  /// The boxes by their place in the tree.
  const std::vector<Index>& order() const { return order_; }

  /// Calls visit(place) for every box in a cell no farther from the query than bound(), a squared
  /// distance that may shrink meanwhile; nearer cells first. A cell never seems farther than the
  /// `squared_length` of the difference to a point inside it, so no tie is missed.
  template <class Bound, class Visit>
  void visit_nearest(const Vec3& query, const Bound& bound, const Visit& visit) const;

  /// Always these operations in this order: rounding is monotone.
  static double squared_length(double x, double y, double z) { return x * x + y * y + z * z; }

 private:
  struct Centre {
    std::array<float, 3> position;
    Index box;
  };
  /// A node with its places [first, last); its halves are the nodes 2n + 1 and 2n + 2.
  struct Cell {
    std::size_t first;
    std::size_t last;
    std::size_t node;
    double distance;
    std::size_t middle() const { return first + (last - first) / 2; }
  };
  void build(std::span<const FloatBox> boxes, std::vector<Centre>& centres, const Cell& cell);

  double squared_distance(std::size_t node, const Vec3& query) const {
    const FloatBox& box = nodes_[node];
    const auto outside = [&](std::size_t axis) {
      const double coordinate = query.data()[axis];
      return std::max({box.minimum[axis] - coordinate, coordinate - box.maximum[axis], 0.0});
    };
    return squared_length(outside(0), outside(1), outside(2));
  }

  std::size_t bucket_size_;
  std::vector<Index> order_;
  std::vector<FloatBox> nodes_;
};

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

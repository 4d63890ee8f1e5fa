/// Binary tree of boxes for nearest-neighbor queries. Each cell (node) is split at the median of
/// its widest axis, with a tight box around each half. Building takes longer than for the Bvh,
/// whose boxes overlap more, but nearest-neighbor queries are several times faster. Depth and cells
/// depend on the number of boxes only. Queries are templates: callers include median_tree_visit.h.
/// Cost: O(n log n) on all allowed threads; deterministic. Reference: Friedman, Bentley & Finkel,
/// "An algorithm for finding best matches in logarithmic expected time", TOMS 3(3), 1977.
/// Departure: elements are boxes instead of points.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/search/float_box.h"

namespace transformesh {

/// Order of the boxes from which a tree is built. `of_tree` means that they are in the order() of a
/// tree of these boxes, so that building takes O(n), without sorting. If this is not true, queries
/// are correct but slow.
enum class BoxOrder { any, of_tree };

class MedianTree {
 public:
  /// Builds a tree. Cells (nodes) of at most `bucket_size` boxes are not split.
  MedianTree(std::span<const FloatBox> boxes, std::size_t bucket_size,
             BoxOrder order = BoxOrder::any);

  /// Returns the indices of the boxes in tree order. Entry `place` is the index of the box that
  /// visit_nearest() calls `place`.
  const std::vector<Index>& order() const { return order_; }

  /// Calls visit(place) for each box in a cell whose squared distance from the query is at most
  /// bound(), nearer cells first. `place` is an index in order(). `bound` may decrease during the
  /// search. The distance of a cell is never larger than `squared_length` of the difference to a
  /// point inside it. Hence no tie is missed.
  template <class Bound, class Visit>
  void visit_nearest(const Vec3& query, const Bound& bound, const Visit& visit) const;

  /// Returns the squared length of a vector. All distances must be computed by these operations in
  /// this order. Rounding is monotonic, so the distance of a box is then at most that of a point in
  /// it.
  static double squared_length(double x, double y, double z) { return x * x + y * y + z * z; }

 private:
  struct Center {
    std::array<float, 3> position;
    Index box;
  };
  /// A node of the tree with the boxes at places [first, last) of the order. Its halves are the
  /// nodes 2 * node + 1 and 2 * node + 2.
  struct Cell {
    std::size_t first;
    std::size_t last;
    std::size_t node;
    double distance;
    std::size_t middle() const { return first + (last - first) / 2; }
  };
  /// The boxes of both halves of a node. Their coordinates are interleaved, so that loops over both
  /// halves are vectorized.
  struct Halves {
    std::array<std::array<float, 2>, 3> minimum;
    std::array<std::array<float, 2>, 3> maximum;
    Halves() = default;
    Halves(const FloatBox& left, const FloatBox& right);
    FloatBox both() const;
    std::array<double, 2> squared_distances(const Vec3& query) const;
  };
  /// Both functions build a cell with the cells below it, and return its box. build() sorts the
  /// boxes; enclose() keeps their order.
  FloatBox build(std::span<const FloatBox> boxes, std::vector<Center>& centers, const Cell& cell);
  FloatBox enclose(std::span<const FloatBox> boxes, const Cell& cell);

  std::size_t bucket_size_;
  std::vector<Index> order_;
  std::vector<Halves> nodes_;  ///< inner nodes of the tree; the root is first
};

}  // namespace transformesh

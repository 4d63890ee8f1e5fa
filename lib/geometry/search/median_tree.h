/// A binary tree of boxes for nearest queries: every cell is cut at the median of its widest axis,
/// with a tight box around each half. It takes longer to build than the Bvh, whose boxes overlap
/// more, and answers nearest queries several times faster. Depth and cells depend on the number of
/// boxes alone. Queries are templates: their callers include median_tree_visit.h. Cost: O(n log n)
/// on all allowed threads; deterministic. Reference: Friedman, Bentley & Finkel, "An algorithm for
/// finding best matches in logarithmic expected time", TOMS 3(3), 1977.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/search/float_box.h"

namespace transformesh {

/// `of_tree`: the boxes come in the order() of a tree over them, so nothing is sorted: O(n). A tree
/// over boxes in another order answers the same, but slowly.
enum class BoxOrder { any, of_tree };

class MedianTree {
 public:
  /// Cells of at most `bucket_size` boxes are not cut.
  MedianTree(std::span<const FloatBox> boxes, std::size_t bucket_size,
             BoxOrder order = BoxOrder::any);

  /// The boxes by their place in the tree.
  const std::vector<Index>& order() const { return order_; }

  /// Calls visit(place) for every box in a cell no farther from the query than bound(), a squared
  /// distance that may shrink meanwhile; nearer cells first. A cell never seems farther than the
  /// `squared_length` of the difference to a point inside it, so no tie is missed.
  template <class Bound, class Visit>
  void visit_nearest(const Vec3& query, const Bound& bound, const Visit& visit) const;

  /// All distances are computed by these operations in this order, as rounding is monotone.
  static double squared_length(double x, double y, double z) { return x * x + y * y + z * z; }

 private:
  struct Center {
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
  /// The boxes of a node's halves, side by side: one loop over both is one of vectors.
  struct Halves {
    std::array<std::array<float, 2>, 3> minimum;
    std::array<std::array<float, 2>, 3> maximum;
    Halves() = default;
    Halves(const FloatBox& left, const FloatBox& right);
    FloatBox both() const;
    std::array<double, 2> squared_distances(const Vec3& query) const;
  };
  /// Build a cell, and return its box.
  FloatBox build(std::span<const FloatBox> boxes, std::vector<Center>& centers, const Cell& cell);
  FloatBox enclose(std::span<const FloatBox> boxes, const Cell& cell);

  std::size_t bucket_size_;
  std::vector<Index> order_;
  std::vector<Halves> nodes_;  ///< that are cut
};

}  // namespace transformesh

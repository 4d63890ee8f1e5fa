/// Nearest of many points. Exact: what is returned is what a search over all points with distances
/// in doubles would return; the lowest index wins ties. Deterministic for any number of threads.
/// Cost: O(n log n) to build on all allowed threads, O(log n) a query on usual data; 45 bytes a
/// point.
/// Reference: Friedman, Bentley & Finkel, "An algorithm for finding best matches in logarithmic
/// expected time", TOMS 3(3), 1977; with a tight box around every cell, as far queries need it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "tm/geometry/float_box.h"
#include "tm/mesh/mesh.h"

namespace transformesh {

class KdTree {
 public:
  /// Copies the points.
  explicit KdTree(std::span<const Vec3> points);
  /// no_index where there are no points.
  Index nearest(const Vec3& query) const;
  /// The `count` nearest (or all, if fewer), closest first.
  std::vector<Index> nearest(const Vec3& query, std::size_t count) const;

 private:
  struct Point {
    std::array<double, 3> position;
    Index index;
  };
  /// Points [first, last) make up the cell of a node; its halves are the nodes 2n + 1 and 2n + 2.
  void build(std::size_t first, std::size_t last, std::size_t node);
  template <class Found>
  void search(const Vec3& query, Found& found) const;

  std::vector<Point> points_;
  std::vector<FloatBox> boxes_;  ///< around the points of each node
};

}  // namespace transformesh

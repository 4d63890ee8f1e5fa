/// Finds the nearest of many points, exactly as a search over all points with distances in doubles
/// does; the lowest index wins ties. Deterministic for any number of threads.
/// Cost: O(n log n) to build on all allowed threads, O(log n) a query on usual data; 35 bytes a
/// point.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "geometry/search/median_tree.h"
#include "transformesh/mesh.h"

namespace transformesh {

class KdTree {
 public:
  /// Copies the points.
  explicit KdTree(std::span<const Vec3> points);
  /// The same over points in an order in which neighbors lie close together (hilbert.h): built in
  /// O(n), and searched more slowly.
  KdTree(std::span<const Vec3> points, std::span<const Index> order);
  /// no_index where there are no points.
  Index nearest(const Vec3& query) const;
  /// The nearest of the points that pass `accept` and are closer than `distance`, or no_index.
  Index nearest_within(const Vec3& query, double distance,
                       const std::function<bool(Index)>& accept) const;
  /// The `count` nearest (or all, if fewer), closest first.
  std::vector<Index> nearest(const Vec3& query, std::size_t count) const;

 private:
  template <class Found>
  void search(const Vec3& query, Found& found) const;

  MedianTree tree_;
  std::vector<Index> order_;  ///< the points by their place in the tree
  std::vector<Vec3> points_;  ///< likewise
};

}  // namespace transformesh

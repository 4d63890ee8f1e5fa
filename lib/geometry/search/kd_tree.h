/// Nearest-neighbor search among points, identical to an exhaustive search with distances in
/// doubles; ties are broken by the lowest index. Deterministic for any number of threads. Cost: O(n
/// log n) to build on all allowed threads; O(log n) per query on usual data; 35 bytes per point.
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
  /// Builds a tree of points whose `order` is spatially coherent (hilbert.h). Building takes O(n)
  /// instead of O(n log n); queries are slower.
  KdTree(std::span<const Vec3> points, std::span<const Index> order);
  /// Returns the nearest point, or no_index if there are no points.
  Index nearest(const Vec3& query) const;
  /// Returns the nearest point closer than `distance` for which `accept` returns true, or no_index
  /// if there is none.
  Index nearest_within(const Vec3& query, double distance,
                       const std::function<bool(Index)>& accept) const;
  /// Returns the `count` nearest points, or all if there are fewer; the closest first.
  std::vector<Index> nearest(const Vec3& query, std::size_t count) const;

 private:
  template <class Found>
  void search(const Vec3& query, Found& found) const;

  MedianTree tree_;
  std::vector<Index> order_;  ///< indices of the points in tree order
  std::vector<Vec3> points_;  ///< positions of the points in tree order
};

}  // namespace transformesh

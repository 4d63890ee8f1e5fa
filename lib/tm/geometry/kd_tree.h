/// Nearest of many points. Exact in doubles; the lowest index wins ties; deterministic.
/// Cost: O(n log n) to build, O(log n) a query on usual data.
#pragma once

#include <span>
#include <vector>

#include "tm/mesh/mesh.h"

namespace transformesh {

class KdTree {
 public:
  explicit KdTree(std::span<const Vec3> points);
  /// no_index where there are no points.
  Index nearest(const Vec3& query) const;
  /// The `count` nearest, closest first.
  std::vector<Index> nearest(const Vec3& query, std::size_t count) const;

 private:
  std::vector<Vec3> points_;    ///< in tree order
  std::vector<Index> indices_;  ///< original index of each
};

}  // namespace transformesh

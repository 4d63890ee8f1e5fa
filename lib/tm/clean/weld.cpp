#include "tm/clean/weld.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tm/geometry/predicates.h"
#include "tm/mesh/disjoint_sets.h"

namespace transformesh {
std::vector<Index> weld(const std::vector<Vec3>& positions, double tolerance) {
  std::vector<Index> order(positions.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    const int sign = compare_positions(positions[a], positions[b]);
    return sign != 0 ? sign < 0 : a < b;
  });

  // Sweep along x: candidates lie within the tolerance there.
  DisjointSets sets(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t k = i + 1; k < order.size(); ++k) {
      const Vec3 step = positions[order[k]] - positions[order[i]];
      if (step[0] > tolerance) break;
      if (tolerance == 0 && step != Vec3::Zero()) break;  // equal positions are adjacent
      if (std::hypot(step[0], step[1], step[2]) <= tolerance) sets.join(order[i], order[k]);
    }
  }
  std::vector<Index> representative(positions.size());
  for (Index i = 0; i < representative.size(); ++i) representative[i] = sets.find(i);
  return representative;
}

}  // namespace transformesh

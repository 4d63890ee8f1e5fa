#include "tm/clean/stitch/weld.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tm/geometry/point_grid.h"
#include "tm/geometry/predicates.h"
#include "tm/mesh/disjoint_sets.h"

namespace transformesh {
std::vector<Index> weld_positions(const std::vector<Vec3>& positions, double tolerance) {
  std::vector<Index> order(positions.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    const int sign = compare_positions(positions[a], positions[b]);
    return sign != 0 ? sign < 0 : a < b;
  });

  // A sweep along x: what is joined lies within the tolerance there.
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

std::vector<Index> snap_positions(const std::vector<Vec3>& positions, std::size_t fixed,
                                  double distance) {
  // In cells this wide doubles tell neighboring cells apart, even where the distance is as small as
  // the spacing of doubles.
  PointGrid grid(16 * distance);
  std::vector<Index> representative(positions.size());
  for (Index i = 0; i < positions.size(); ++i) {
    representative[i] = i;
    double least = distance;
    if (i >= fixed) {
      grid.visit_around(positions[i], [&](Index k) {
        const double length = (positions[k] - positions[i]).stableNorm();
        if (length > least || (length == least && representative[i] < i)) return;
        least = length;
        representative[i] = k;
      });
    }
    if (representative[i] == i) grid.add(positions[i], i);
  }
  return representative;
}

}  // namespace transformesh

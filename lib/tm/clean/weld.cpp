#include "tm/clean/weld.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tm/geometry/predicates.h"

namespace transformesh {
namespace {

Index find_root(std::vector<Index>& parent, Index i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

void join(std::vector<Index>& parent, Index a, Index b) {
  a = find_root(parent, a);
  b = find_root(parent, b);
  parent[std::max(a, b)] = std::min(a, b);
}

}  // namespace

std::vector<Index> weld(const std::vector<Vec3>& positions, double tolerance) {
  std::vector<Index> order(positions.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    const int sign = compare_positions(positions[a], positions[b]);
    return sign != 0 ? sign < 0 : a < b;
  });

  // Sweep along x: candidates lie within the tolerance there.
  std::vector<Index> parent(positions.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t k = i + 1; k < order.size(); ++k) {
      const Vec3 step = positions[order[k]] - positions[order[i]];
      if (step[0] > tolerance) break;
      if (tolerance == 0 && step != Vec3::Zero()) break;  // equal positions are adjacent
      if (step.norm() <= tolerance) join(parent, order[i], order[k]);
    }
  }
  for (Index i = 0; i < parent.size(); ++i) parent[i] = find_root(parent, i);
  return parent;
}

}  // namespace transformesh

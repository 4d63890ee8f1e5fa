#include "tm/clean/stitch/weld.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "tm/geometry/predicates.h"
#include "tm/mesh/disjoint_sets.h"

namespace transformesh {
namespace {

// Points by cells of a grid. None is missed in the cells around that of a query.
class PointGrid {
 public:
  explicit PointGrid(double spacing) : spacing_(spacing) {}

  void add(const Vec3& position, Index index) { cells_[cell(position)].push_back(index); }
  template <class Visit>
  void visit_around(const Vec3& position, const Visit& visit) const {
    const Cell middle = cell(position);
    constexpr std::array<double, 3> steps = {-1, 0, 1};
    for (std::size_t i = 0; i < 27; ++i) {
      const Cell around = {middle[0] + steps[i % 3], middle[1] + steps[i / 3 % 3],
                           middle[2] + steps[i / 9]};
      const auto found = cells_.find(around);
      if (found == cells_.end()) continue;
      for (const Index index : found->second) visit(index);
    }
  }

 private:
  using Cell = std::array<double, 3>;  // whole numbers, however many
  Cell cell(const Vec3& p) const {
    return {std::floor(p[0] / spacing_), std::floor(p[1] / spacing_), std::floor(p[2] / spacing_)};
  }

  double spacing_;
  std::map<Cell, std::vector<Index>> cells_;
};

}  // namespace

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

std::vector<Index> gather(const std::vector<Vec3>& positions, std::size_t fixed, double distance) {
  // Cells wide enough that doubles tell neighbours apart, though the distance be but their spacing.
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

#include "tm/clean/rounding/crowds.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "tm/mesh/disjoint_sets.h"

namespace transformesh {
namespace {

constexpr std::size_t fewest = 30;
constexpr double most_spacings = 4;  // along an axis for each point

using Cell = std::array<double, 3>;  // whole numbers, however many

// The occupied cells of a grid, joined with those around them: points of different groups are
// farther apart than a cell is wide.
class Groups {
 public:
  Groups(const std::vector<Vec3>& positions, double size);
  std::vector<std::vector<Index>> members();

 private:
  DisjointSets join_cells() const;

  std::map<Cell, std::vector<Index>> cells_;
  std::size_t positions_;
};

Groups::Groups(const std::vector<Vec3>& positions, double size) : positions_(positions.size()) {
  for (Index i = 0; i < positions.size(); ++i) {
    const Vec3& p = positions[i];
    cells_[{std::floor(p[0] / size), std::floor(p[1] / size), std::floor(p[2] / size)}].push_back(
        i);
  }
}

// By the first point of each cell.
DisjointSets Groups::join_cells() const {
  DisjointSets sets(positions_);
  for (const auto& [cell, points] : cells_) {
    for (std::size_t i = 0; i < 13; ++i) {  // those before it; it comes after the other half
      constexpr std::array<double, 3> steps = {-1, 0, 1};
      const Cell around = {cell[0] + steps[i / 9], cell[1] + steps[i / 3 % 3],
                           cell[2] + steps[i % 3]};
      const auto found = cells_.find(around);
      if (found != cells_.end()) sets.join(points.front(), found->second.front());
    }
  }
  return sets;
}

std::vector<std::vector<Index>> Groups::members() {
  DisjointSets sets = join_cells();
  std::vector<std::vector<Index>> result(positions_);
  for (const auto& [cell, points] : cells_) {
    std::vector<Index>& group = result[sets.find(points.front())];
    group.insert(group.end(), points.begin(), points.end());
  }
  return result;
}

}  // namespace

Eigen::AlignedBox3d box_around(const std::vector<Vec3>& positions,
                               const std::vector<Index>& group) {
  Eigen::AlignedBox3d box;
  for (const Index i : group) box.extend(positions[i]);
  return box;
}

std::vector<std::vector<Index>> find_crowds(const std::vector<Vec3>& positions, double spacing) {
  std::vector<std::vector<Index>> crowds;
  std::vector<char> is_taken(positions.size(), 0);
  const auto is_crowd = [&](const std::vector<Index>& group, double size) {
    if (group.size() < fewest) return false;
    const double extent = box_around(positions, group).sizes().maxCoeff();
    return extent <= size && extent < most_spacings * spacing * static_cast<double>(group.size()) &&
           std::none_of(group.begin(), group.end(), [&](Index i) { return is_taken[i]; });
  };
  for (int doublings = 0; std::ldexp(1, doublings) <= widest_crowd; ++doublings) {
    const double size = std::ldexp(spacing, doublings);
    for (std::vector<Index>& group : Groups(positions, size).members()) {
      if (!is_crowd(group, size)) continue;
      std::sort(group.begin(), group.end());
      for (const Index i : group) is_taken[i] = 1;
      crowds.push_back(std::move(group));
    }
  }
  return crowds;
}

}  // namespace transformesh

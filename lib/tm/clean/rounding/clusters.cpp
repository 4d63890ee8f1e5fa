#include "tm/clean/rounding/clusters.h"

#include <algorithm>
#include <cmath>

#include "tm/geometry/point_grid.h"
#include "tm/mesh/disjoint_sets.h"

namespace transformesh {
namespace {

constexpr std::size_t fewest_points = 30;
constexpr double most_spacings = 4;  // of its extent along an axis, per point

// Groups points so that those of different groups are farther apart than the size along some axis:
// it joins the points of grid cells that touch.
std::vector<std::vector<Index>> group_points(const std::vector<Vec3>& positions, double size) {
  PointGrid grid(size);
  for (Index i = 0; i < positions.size(); ++i) grid.add(positions[i], i);
  DisjointSets sets(positions.size());
  grid.visit_adjacent_cells(
      [&](const auto& points, const auto& others) { sets.join(points.front(), others.front()); });
  std::vector<std::vector<Index>> groups(positions.size());
  grid.visit_cells([&](const auto& points) {
    std::vector<Index>& group = groups[sets.find(points.front())];
    group.insert(group.end(), points.begin(), points.end());
  });
  return groups;
}

}  // namespace

Eigen::AlignedBox3d box_of_group(const std::vector<Vec3>& positions,
                                 const std::vector<Index>& group) {
  Eigen::AlignedBox3d box;
  for (const Index i : group) box.extend(positions[i]);
  return box;
}

std::vector<std::vector<Index>> find_clusters(const std::vector<Vec3>& positions, double spacing) {
  std::vector<std::vector<Index>> clusters;
  std::vector<char> is_taken(positions.size(), 0);
  const auto is_cluster = [&](const std::vector<Index>& group, double size) {
    if (group.size() < fewest_points) return false;
    const double extent = box_of_group(positions, group).sizes().maxCoeff();
    return extent <= size && extent < most_spacings * spacing * static_cast<double>(group.size()) &&
           std::none_of(group.begin(), group.end(), [&](Index i) { return is_taken[i]; });
  };
  for (int doublings = 0; std::ldexp(1, doublings) <= widest_cluster; ++doublings) {
    const double size = std::ldexp(spacing, doublings);
    for (std::vector<Index>& group : group_points(positions, size)) {
      if (!is_cluster(group, size)) continue;
      std::sort(group.begin(), group.end());
      for (const Index i : group) is_taken[i] = 1;
      clusters.push_back(std::move(group));
    }
  }
  return clusters;
}

}  // namespace transformesh

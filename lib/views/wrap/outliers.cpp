#include "views/wrap/outliers.h"

#include <algorithm>
#include <cmath>

#include "geometry/search/kd_tree.h"
#include "support/parallel.h"
#include "views/wrap/scale_normalization.h"

namespace transformesh {
namespace {

constexpr std::size_t points_per_task = 512;
constexpr std::size_t neighbors = 6;
constexpr double jump = 4;  ///< see the table in the header
constexpr double most_outliers = 1.0 / 20;
/// Smaller clouds have no outliers. For comparison, one in seven scans of 40 points on a plane
/// would lose some.
constexpr std::size_t least_points = 100;

std::vector<double> distances_to_neighbors(const std::vector<Vec3>& points) {
  const KdTree tree(points);
  std::vector<double> distances(points.size());
  parallel_for(points.size(), points_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const Index farthest = tree.nearest(points[i], neighbors + 1).back();
      distances[i] = (points[farthest] - points[i]).norm();
    }
  });
  return distances;
}

/// Returns the least neighbor distance of an outlier; infinite if there is none.
double least_distance(std::vector<double> distances) {
  const auto most = static_cast<std::size_t>(most_outliers * static_cast<double>(distances.size()));
  std::ranges::sort(distances, std::ranges::greater());
  for (std::size_t i = most; i > 0; --i)
    if (distances[i - 1] > 0 && distances[i - 1] >= jump * distances[i]) return distances[i - 1];
  return HUGE_VAL;
}

}  // namespace

std::vector<Index> find_outliers(std::span<const Vec3> points) {
  std::vector<Index> outliers;
  const std::vector<std::size_t> first = first_equals(points);
  std::vector<Vec3> distinct;
  std::vector<std::size_t> place(points.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (first[i] != i) continue;
    place[i] = distinct.size();
    distinct.push_back(points[i]);
  }
  if (distinct.size() < least_points) return outliers;
  const std::vector<double> distances =
      distances_to_neighbors(ScaleNormalization(diagonal_of(points)).to_unit(distinct));
  const double least = least_distance(distances);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (distances[place[first[i]]] >= least) outliers.push_back(static_cast<Index>(i));
  return outliers;
}

}  // namespace transformesh

#include "views/wrap/outliers.h"

#include <algorithm>

#include "geometry/search/kd_tree.h"
#include "mesh/disjoint_sets.h"
#include "support/parallel.h"
#include "views/wrap/scale_normalization.h"

namespace transformesh {
namespace {

/// Two neighbors are connected if their distance is at most `reach` times the spacing at both.
/// Large connected groups are bodies. Another point is an outlier if its spacing is at least `jump`
/// times the spacing at the nearest point of a body. The table in outliers.h shows the effects of
/// both factors.
constexpr double reach = 2;
constexpr double jump = 4;
/// Points of a connected group may be outliers if the group has less than this fraction of all
/// points. A few percent of the points of sparse reconstructions are outliers. With twice this
/// fraction, a second, sparsely sampled part of the object would be lost more often.
constexpr double least_body = 1.0 / 20;
/// In point clouds with fewer points than this, no point counts as an outlier. Otherwise, connected
/// groups of fewer than five points would already count as parts of the object.
constexpr std::size_t least_points = 100;

struct Neighborhoods {
  /// For each point, its own index and those of its six nearest neighbors.
  std::vector<std::vector<Index>> nearest;
  std::vector<double> spacing;  ///< for each point, the distance to its sixth neighbor
};

Neighborhoods neighborhoods_of(const std::vector<Vec3>& points) {
  constexpr std::size_t points_per_task = 512;  // points per parallel task; affects time only
  // The spacing at a point is the distance to its sixth neighbor.
  constexpr std::size_t neighbors = 6;
  const KdTree tree(points);
  Neighborhoods result{std::vector<std::vector<Index>>(points.size()),
                       std::vector<double>(points.size())};
  parallel_for(points.size(), points_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      result.nearest[i] = tree.nearest(points[i], neighbors + 1);
      result.spacing[i] = (points[result.nearest[i].back()] - points[i]).norm();
    }
  });
  return result;
}

/// Connects two neighboring points if their distance is at most `reach` times the spacing at both.
/// Returns the connected groups.
DisjointSets groups_of(const std::vector<Vec3>& points, const Neighborhoods& around) {
  DisjointSets groups(points.size());
  for (Index i = 0; i < points.size(); ++i) {
    for (const Index j : around.nearest[i]) {
      const double limit = reach * std::min(around.spacing[i], around.spacing[j]);
      if ((points[i] - points[j]).norm() <= limit) groups.join(i, j);
    }
  }
  return groups;
}

/// Returns 1 for each point that is an outlier, else 0.
std::vector<char> outliers_among(const std::vector<Vec3>& points) {
  const Neighborhoods around = neighborhoods_of(points);
  DisjointSets groups = groups_of(points, around);
  std::vector<std::size_t> sizes(points.size(), 0);
  for (Index i = 0; i < points.size(); ++i) ++sizes[groups.find(i)];
  const double least = least_body * static_cast<double>(points.size());
  std::vector<Vec3> body;
  std::vector<double> spacing;
  std::vector<Index> rest;
  for (Index i = 0; i < points.size(); ++i) {
    if (static_cast<double>(sizes[groups.find(i)]) < least) {
      rest.push_back(i);
      continue;
    }
    body.push_back(points[i]);
    spacing.push_back(around.spacing[i]);
  }
  std::vector<char> are_outliers(points.size(), 0);
  if (body.empty() || rest.empty()) return are_outliers;
  const KdTree tree(body);
  for (const Index i : rest)
    are_outliers[i] = around.spacing[i] >= jump * spacing[tree.nearest(points[i], 1)[0]] ? 1 : 0;
  return are_outliers;
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
  const std::vector<char> are_outliers =
      outliers_among(ScaleNormalization(diagonal_of(points)).to_unit(distinct));
  for (std::size_t i = 0; i < points.size(); ++i)
    if (are_outliers[place[first[i]]] != 0) outliers.push_back(static_cast<Index>(i));
  return outliers;
}

}  // namespace transformesh

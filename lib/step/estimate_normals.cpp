#include "step/estimate_normals.h"

#include <Eigen/Dense>
#include <algorithm>
#include <queue>
#include <tuple>

#include "geometry/search/kd_tree.h"
#include "support/parallel.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

constexpr std::size_t points_per_task = 1024;  ///< affects time only

using Neighbors = std::vector<std::vector<Index>>;

Neighbors find_neighbors(std::span<const Vec3> points, std::size_t count) {
  const KdTree tree(points);
  Neighbors neighbors(points.size());
  parallel_for(points.size(), points_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last; ++p) neighbors[p] = tree.nearest(points[p], count + 1);
  });
  return neighbors;
}

Vec3 direction_of_least_spread(std::span<const Vec3> points, const std::vector<Index>& chosen) {
  // Offsets are relative to one of the points, so that the offsets of equal points are exactly
  // zero.
  const Vec3& origin = points[chosen[0]];
  Vec3 mean = Vec3::Zero();
  for (const Index p : chosen) mean += (points[p] - origin) / static_cast<double>(chosen.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Index p : chosen) {
    const Vec3 offset = points[p] - origin - mean;
    spread += offset * offset.transpose();
  }
  if (spread.trace() == 0) return Vec3::Zero();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread / spread.trace());
  return solver.eigenvectors().col(0).normalized();
}

// Returns the symmetric neighborhood graph: p and q are adjacent if one is a neighbor of the other.
Neighbors made_mutual(const Neighbors& neighbors) {
  Neighbors mutual(neighbors.size());
  for (Index p = 0; p < neighbors.size(); ++p) {
    for (const Index q : neighbors[p]) {
      if (q == p) continue;
      mutual[p].push_back(q);
      mutual[q].push_back(p);
    }
  }
  return mutual;
}

/// Propagates signs by Prim's algorithm, which starts at the highest point not yet reached. The
/// tree grows along the edge whose normals are most parallel, and flips the new normal if it is
/// opposite.
class Orientation {
 public:
  Orientation(std::span<const Vec3> points, const Neighbors& neighbors, std::vector<Vec3>& normals)
      : points_(points), neighbors_(neighbors), normals_(normals), is_done_(points.size(), false) {}

  void run() {
    std::vector<Index> by_height(points_.size());
    for (Index p = 0; p < by_height.size(); ++p) by_height[p] = p;
    std::stable_sort(by_height.begin(), by_height.end(),
                     [&](Index a, Index b) { return points_[a].z() > points_[b].z(); });
    for (const Index root : by_height) {
      if (is_done_[root]) continue;
      if (normals_[root].z() < 0) normals_[root] = -normals_[root];
      settle(root);
      grow();
    }
  }

 private:
  // Cost of an edge, its end outside the tree, its end in the tree.
  using Candidate = std::tuple<double, Index, Index>;

  void settle(Index point) {
    is_done_[point] = true;
    for (const Index next : neighbors_[point]) {
      if (is_done_[next]) continue;
      waiting_.emplace(1 - std::abs(normals_[point].dot(normals_[next])), next, point);
    }
  }

  void grow() {
    while (!waiting_.empty()) {
      const auto [cost, to, from] = waiting_.top();
      waiting_.pop();
      if (is_done_[to]) continue;
      if (normals_[to].dot(normals_[from]) < 0) normals_[to] = -normals_[to];
      settle(to);
    }
  }

  std::span<const Vec3> points_;
  const Neighbors& neighbors_;
  std::vector<Vec3>& normals_;
  std::vector<bool> is_done_;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> waiting_;
};

}  // namespace

std::vector<Vec3> estimate_normals(std::span<const Vec3> points, std::size_t neighbors) {
  if (points.size() < 4) {
    throw InputError(
        "normals cannot be estimated from fewer than four points; give them as nx ny nz");
  }
  const Neighbors nearest = find_neighbors(points, neighbors);
  std::vector<Vec3> normals(points.size());
  parallel_for(points.size(), points_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last; ++p) {
      normals[p] = direction_of_least_spread(points, nearest[p]);
    }
  });
  const Neighbors mutual = made_mutual(nearest);
  Orientation(points, mutual, normals).run();
  return normals;
}

}  // namespace transformesh

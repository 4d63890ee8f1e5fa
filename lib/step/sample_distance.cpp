#include "step/sample_distance.h"

#include <cmath>

#include "support/parallel.h"

namespace transformesh {
namespace {

/// The points, in the order of the Hilbert curve, are divided into runs of this length. An estimate
/// depends only on earlier points of the same run. The length is fixed, so that estimates do not
/// depend on the number of threads.
constexpr std::size_t run_length = 512;

/// The last search yields estimates for points that are at most this fraction of the found distance
/// away from its point. A larger fraction saves searches but makes estimates less accurate.
constexpr double reach = 0.4;

/// The point and the result of the last search. Distances of nearby points are estimated from them.
struct Anchor {
  Vec3 point = Vec3::Zero();
  SearchedDistance found;

  bool is_far(const Vec3& other, double exact_within) const {
    return std::abs(found.distance) / (1 + far_tolerance) - (other - point).norm() > exact_within;
  }
  bool reaches(const Vec3& other) const {
    return (other - point).norm() <= reach * std::abs(found.distance);
  }
  double estimate(const Vec3& other) const {
    return found.distance + found.gradient.dot(other - point);
  }
};

}  // namespace

SearchedDistance searched_distance(const Vec3& point, const Vec3& closest, double sign) {
  const Vec3 way = point - closest;
  const double distance = way.norm();
  if (distance == 0) return {};
  return {sign * distance, sign * way / distance};
}

std::vector<double> sample_distance(
    std::span<const Vec3> points, std::span<const Index> order, double exact_within,
    const std::function<SearchedDistance(Index point, double sign, Index hint)>& search) {
  std::vector<double> distances(points.size());
  const std::size_t runs = (order.size() + run_length - 1) / run_length;
  parallel_for(runs, 1, [&](std::size_t first_run, std::size_t last_run) {
    for (std::size_t run = first_run; run < last_run; ++run) {
      Anchor anchor;
      const std::size_t end = std::min((run + 1) * run_length, order.size());
      for (std::size_t i = run * run_length; i < end; ++i) {
        const Vec3& point = points[order[i]];
        const bool is_far = anchor.is_far(point, exact_within);
        if (is_far && anchor.reaches(point)) {
          distances[order[i]] = anchor.estimate(point);
        } else {
          const double sign = is_far ? std::copysign(1, anchor.found.distance) : 0;
          anchor = {point, search(order[i], sign, anchor.found.face)};
          distances[order[i]] = anchor.found.distance;
        }
      }
    }
  });
  return distances;
}

}  // namespace transformesh

#include "views/wrap/point_spacing.h"

#include <algorithm>
#include <vector>

#include "geometry/search/kd_tree.h"
#include "support/parallel.h"

namespace transformesh {

double point_spacing(std::span<const Vec3> points) {
  // Number of neighbors, chosen by hand: few, so that the spacing is local.
  constexpr std::size_t neighbors = 6;
  constexpr std::size_t points_per_task = 512;  // affects time only
  /// Ratio of two lengths: the side of a square, and the radius of a disk with the area of six such
  /// squares. The ratio is sqrt(pi / 6).
  constexpr double side_by_radius = 0.7236;
  if (points.size() <= neighbors) return 0;
  const std::vector<Vec3> places(points.begin(), points.end());
  const KdTree tree(places);
  std::vector<double> distances(places.size());
  parallel_for(places.size(), points_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      distances[i] = (places[tree.nearest(places[i], neighbors + 1).back()] - places[i]).norm();
  });
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return side_by_radius * *middle;
}

}  // namespace transformesh

#include "clean/rounding/triangle_distance.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace transformesh {

Vec3 unit_normal(const Triangle& t) {
  std::size_t corner = 0;
  double longest = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const double length = (t[(i + 2) % 3] - t[(i + 1) % 3]).stableNorm();
    if (length <= longest) continue;
    longest = length;
    corner = i;
  }
  const Vec3 first = (t[(corner + 1) % 3] - t[corner]).stableNormalized();
  const Vec3 second = (t[(corner + 2) % 3] - t[corner]).stableNormalized();
  return first.cross(second).stableNormalized();
}

double height_over(const Triangle& t, const Vec3& unit_normal, const Vec3& point) {
  const auto is_nearer = [&](const Vec3& a, const Vec3& b) {
    return (a - point).stableNorm() < (b - point).stableNorm();
  };
  return unit_normal.dot(point - *std::min_element(t.begin(), t.end(), is_nearer));
}

LineDistance distance_from_line(const Vec3& a, const Vec3& b, const Vec3& point) {
  const bool is_a_nearer = (point - a).stableNorm() <= (point - b).stableNorm();
  const Vec3& near = is_a_nearer ? a : b;
  const Vec3 along = ((is_a_nearer ? b : a) - near).stableNormalized();
  const Vec3 to = point - near;
  return {along.cross(to).stableNorm(), -to.dot(along)};
}

double relative_height(const Triangle& t) {
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i)
    longest = std::max(longest, (t[(i + 1) % 3] - t[i]).stableNorm());
  if (!(longest > 0)) return 0;
  return ((t[1] - t[0]) / longest).cross((t[2] - t[0]) / longest).stableNorm();
}

}  // namespace transformesh

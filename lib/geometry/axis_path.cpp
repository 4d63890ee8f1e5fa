#include "geometry/axis_path.h"

#include <algorithm>
#include <cmath>

#include "geometry/numbers/predicates.h"

namespace transformesh {
namespace {

/// True if the bounding box of the triangle meets a segment that is parallel to an axis.
bool is_near(const Triangle& t, const Vec3& start, double end, int axis) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto misses = [&](int i, double low, double high) {
    return (t[0][i] < low && t[1][i] < low && t[2][i] < low) ||
           (t[0][i] > high && t[1][i] > high && t[2][i] > high);
  };
  return !misses(u, start[u], start[u]) && !misses(v, start[v], start[v]) &&
         !misses(axis, std::min(start[axis], end), std::max(start[axis], end));
}

}  // namespace

void AxisPath::add(const Triangle& triangle) {
  Vec3 start = from_;
  for (int axis = 0; axis < 3; ++axis) {
    if (start[axis] == to_[axis]) continue;
    if (is_near(triangle, start, to_[axis], axis)) cross(triangle, start, axis);
    start[axis] = to_[axis];
  }
}

void AxisPath::cross(const Triangle& t, const Vec3& start, int axis) {
  const PlaneProjection view{(axis + 1) % 3, (axis + 2) % 3};
  bool left = false, right = false, on = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const int side = orient2d(t[k], t[(k + 1) % 3], start, view);
    left |= side > 0;
    right |= side < 0;
    on |= side == 0;
  }
  if (left && right) return;
  if (on) {
    is_certain_ = is_certain_ && collinear(t[0], t[1], t[2]);
    return;
  }
  // The sign of the face's normal along the axis. It determines on which side of the face an end of
  // the path at infinity is.
  const int up = left ? 1 : -1;
  Vec3 end = start;
  end[axis] = to_[axis];
  const int direction = to_[axis] > start[axis] ? 1 : -1;
  const int side_of_start = orient3d(t[0], t[1], t[2], start);
  const int side_of_end = std::isinf(to_[axis]) ? up * direction : orient3d(t[0], t[1], t[2], end);
  is_certain_ = is_certain_ && side_of_start != 0 && side_of_end != 0;
  if (side_of_start != side_of_end) change_ += side_of_start;
}

Vec3 spread_point(const Eigen::AlignedBox3d& box, int i) {
  // Powers 1 / g, 1 / g^2 and 1 / g^3, where g is the positive root of x^4 = x + 1.
  constexpr std::array<double, 3> step{0.8191725133961645, 0.6710436067037893, 0.5497004779019703};
  Vec3 point;
  for (int k = 0; k < 3; ++k) {
    const double sum = 0.5 + (i + 1) * step[static_cast<std::size_t>(k)];
    const double share = sum - std::floor(sum);
    point[k] = box.min()[k] * (1 - share) + box.max()[k] * share;
  }
  return point;
}

}  // namespace transformesh

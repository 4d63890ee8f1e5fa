#include "geometry/plane_distances.h"

#include <algorithm>
#include <cmath>

#include "geometry/numbers/exact_plane_distance.h"
#include "geometry/numbers/machine_epsilon.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

/// Bound of the relative error of a sum of three products and a number, with a wide margin.
constexpr double relative_error = 16 * machine_epsilon;

/// Returns the sign of normal * point - offset if doubles decide it, otherwise 0. Also returns 0 if
/// numbers overflow.
int filtered_side(const CutPlane& plane, const Vec3& point) {
  const double value = plane.normal.dot(point) - plane.offset;
  const double size = plane.normal.cwiseAbs().dot(point.cwiseAbs()) + std::abs(plane.offset);
  const double bound = relative_error * size + underflow_guard;
  return static_cast<int>(value > bound) - static_cast<int>(value < -bound);
}

}  // namespace

PlaneDistances::PlaneDistances(const Mesh& mesh, const CutPlane& plane) : mesh_(mesh) {
  const double length = plane.normal.stableNorm();
  if (!(length > 0) || !std::isfinite(length) || !std::isfinite(plane.offset / length))
    throw UsageError("the normal of the plane has no direction: it needs a length other than 0");
  normal_ = plane.normal / length;
  offset_ = plane.offset / length;
  distances_.reserve(mesh.positions.size());
  for (const Vec3& p : mesh.positions) {
    const double distance = normal_.dot(p) - offset_;
    const int side = filtered_side(plane, p);
    const bool is_certain = (side > 0 && distance > 0) || (side < 0 && distance < 0);
    distances_.push_back(is_certain ? distance
                                    : exact_plane_distance(plane.normal, plane.offset, length, p));
  }
}

PlaneDistances::Crossing PlaneDistances::crossing(Index a, Index b) const {
  const auto [low, high] = std::minmax(a, b);
  // An end in the plane is the intersection. Projecting it would move it by a rounding error.
  if (distances_[low] == 0) return {low, high, 0, mesh_.positions[low]};
  if (distances_[high] == 0) return {low, high, 1, mesh_.positions[high]};
  const double weight = distances_[low] / (distances_[low] - distances_[high]);
  const Vec3& from = mesh_.positions[low];
  Vec3 position = from + weight * (mesh_.positions[high] - from);
  // Project the point onto the plane once more, to reduce its rounding error. For a plane
  // perpendicular to an axis, the result is exact.
  position -= (normal_.dot(position) - offset_) * normal_;
  return {low, high, weight, position};
}

}  // namespace transformesh

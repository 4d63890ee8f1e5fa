#include "geometry/plane_distances.h"

#include <algorithm>
#include <cmath>

#include "transformesh/errors.h"

namespace transformesh {

PlaneDistances::PlaneDistances(const Mesh& mesh, const CutPlane& plane) : mesh_(mesh) {
  const double length = plane.normal.stableNorm();
  if (!(length > 0) || !std::isfinite(length) || !std::isfinite(plane.offset / length))
    throw UsageError("the normal of the plane has no direction: it needs a length other than 0");
  normal_ = plane.normal / length;
  offset_ = plane.offset / length;
  distances_.reserve(mesh.positions.size());
  for (const Vec3& p : mesh.positions) distances_.push_back(normal_.dot(p) - offset_);
}

PlaneDistances::Crossing PlaneDistances::crossing(Index a, Index b) const {
  const auto [low, high] = std::minmax(a, b);
  const double weight = distances_[low] / (distances_[low] - distances_[high]);
  const Vec3& from = mesh_.positions[low];
  Vec3 position = from + weight * (mesh_.positions[high] - from);
  // Project the point onto the plane once more, to reduce its rounding error. For a plane
  // perpendicular to an axis, the result is exact.
  position -= (normal_.dot(position) - offset_) * normal_;
  return {low, high, weight, position};
}

}  // namespace transformesh

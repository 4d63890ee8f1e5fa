#include "tm/views/photo/warp.h"

#include <Eigen/LU>
#include <algorithm>

#include "tm/views/images/interpolation.h"

namespace transformesh {
namespace {

/// The pixel and the depth at which the other view has a point, and how the pixel moves as the
/// point goes along its ray.
struct Landing {
  double x, y, depth;
  double along_x, along_y;
};

/// The point at `depth` on the ray whose image has the direction (a, b, c).
Landing land(double a, double b, double c, double depth, const Vec3& shift) {
  const double far = depth * c + shift.z();
  const double inverse = 1 / far;
  const double x = (depth * a + shift.x()) * inverse;
  const double y = (depth * b + shift.y()) * inverse;
  return {x, y, far, (a - x * c) * inverse, (b - y * c) * inverse};
}

/// The largest depth of the pixels that a place is between: a point there is hidden where it is
/// clearly behind that. Pixels without a face have depth 0.
float reach(const GrayImage& depths, int x, int y) {
  const float* const top = depths.row(y) + x;
  const float* const bottom = top + depths.width;
  return std::max({top[0], top[1], bottom[0], bottom[1]});
}

}  // namespace

Warp::Warp(const View& reference, const SeenSurface& seen_by_reference, const View& other,
           const HeldImage& depths_of_other, double depth_tolerance)
    : reference_(reference.image.unpacked(room_[0])),
      seen_(seen_by_reference),
      other_(other.image.unpacked(room_[1])),
      depths_(depths_of_other.unpacked(room_[2])),
      nearer_(1 - depth_tolerance) {
  const Projection projection = other.camera.projection();
  const Eigen::Matrix3d directions = projection.leftCols<3>();
  turn_ =
      directions * reference.camera.rotation.transpose() * reference.camera.intrinsics.inverse();
  shift_ = directions * reference.camera.center() + projection.col(3);
}

template <Interpolation interpolation>
void Warp::row(int y, const WarpedRow& out) const {
  constexpr int first = margin<interpolation>;
  const int end_x = other_.width - 1 - first;
  const int end_y = other_.height - 1 - first;
  const Vec3 start = turn_ * Vec3(0, y, 1);
  const Vec3 step = turn_.col(0);

  for (int x = seen_.first_column; x < seen_.end_column; ++x) {
    const int i = x - seen_.first_column;
    out.is_seen[i] = out.reference[i] = out.other[i] = out.slope[i] = 0;
    const float depth = seen_.depth.at(x, y);
    if (depth == 0) continue;
    const Landing at = land(start.x() + x * step.x(), start.y() + x * step.y(),
                            start.z() + x * step.z(), depth, shift_);
    if (!(at.depth > 0 && at.x >= first && at.y >= first && at.x < end_x && at.y < end_y)) continue;
    const int to_x = static_cast<int>(at.x);
    const int to_y = static_cast<int>(at.y);
    if (reach(depths_, to_x, to_y) <= at.depth * nearer_) continue;
    const Sample found = sample<interpolation>(
        other_, to_x, to_y, static_cast<float>(at.x - to_x), static_cast<float>(at.y - to_y),
        static_cast<float>(at.along_x), static_cast<float>(at.along_y));
    out.is_seen[i] = 1;
    out.reference[i] = reference_.at(x, y) - middle_level;
    out.other[i] = found.level - middle_level;
    out.slope[i] = found.slope;
  }
}

void Warp::row(int y, Interpolation interpolation, const WarpedRow& out) const {
  if (interpolation == Interpolation::bilinear)
    row<Interpolation::bilinear>(y, out);
  else
    row<Interpolation::catmull_rom>(y, out);
}

}  // namespace transformesh

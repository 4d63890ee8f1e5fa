#include "views/photo/warp.h"

#include <Eigen/LU>
#include <algorithm>

#include "raster/camera.h"
#include "views/cameras/view.h"
#include "views/images/interpolation.h"

namespace transformesh {
namespace {

/// Projection of a surface point to the other view: pixel and depth. The point lies on a viewing
/// ray of the reference view. `along_x` and `along_y` are derivatives of the pixel with respect to
/// the point's depth in the reference view.
struct Landing {
  double x, y, depth;
  double along_x, along_y;
};

/// Projects a point to the other view. The point is at `depth` on a ray of the reference view,
/// whose direction is (a, b, c) in homogeneous pixels of the other view.
Landing land(double a, double b, double c, double depth, const Vec3& shift) {
  const double far = depth * c + shift.z();
  const double inverse = 1 / far;
  const double x = (depth * a + shift.x()) * inverse;
  const double y = (depth * b + shift.y()) * inverse;
  return {x, y, far, (a - x * c) * inverse, (b - y * c) * inverse};
}

/// Returns the rectangle of pixels that interpolation at points in `seen` reads. Returns the whole
/// image if it is not packed.
PixelBox part_of(const PackableImage& image, const PixelBox& seen) {
  /// Cubic interpolation at a point in `seen` reads up to this number of pixels outside of `seen`.
  constexpr int around = 2;
  if (!image.is_packed()) return {0, image.width, 0, image.height};
  return {std::max(seen.first_column - around, 0), std::min(seen.end_column + around, image.width),
          std::max(seen.first_row - around, 0), std::min(seen.end_row + around, image.height)};
}

const GrayImage& unpacked(const PackableImage& image, const PixelBox& part, GrayImage& room) {
  if (!image.is_packed()) return image.unpacked(room);
  image.unpack_rectangle(part.first_column, part.first_row, part.columns(), part.rows(), room);
  return room;
}

}  // namespace

Warp::Warp(const View& reference, const VisibleSurface& seen_by_reference, const View& other,
           const VisibleDepths& depths_of_other, double depth_tolerance, WarpRoom& room)
    : reference_(reference.image),
      seen_(seen_by_reference),
      width_(other.image.width),
      height_(other.image.height),
      part_(part_of(other.image, depths_of_other.box())),
      other_(unpacked(other.image, part_, room.image)),
      depths_(depths_of_other.opened(room.depths)),
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
  const int end_x = width_ - 1 - first;
  const int end_y = height_ - 1 - first;
  const Vec3 start = turn_ * Vec3(0, y, 1);
  const Vec3 step = turn_.col(0);
  const PixelBox& columns = seen_.compared;
  const float* const depths = seen_.depth.row(y - seen_.box.first_row);
  if (seen_.intensity.empty()) {
    reference_.read(columns.first_column, y, columns.columns(), out.reference);
  } else {
    std::copy_n(seen_.intensity.row(y - seen_.box.first_row) + columns.first_column -
                    seen_.box.first_column,
                columns.columns(), out.reference);
  }

  for (int x = columns.first_column; x < columns.end_column; ++x) {
    const int i = x - columns.first_column;
    const float intensity = out.reference[i];
    out.is_seen[i] = out.reference[i] = out.other[i] = out.slope[i] = 0;
    const float depth = depths[x - seen_.box.first_column];
    if (depth == 0) continue;
    const Landing at = land(start.x() + x * step.x(), start.y() + x * step.y(),
                            start.z() + x * step.z(), depth, shift_);
    if (!(at.depth > 0 && at.x >= first && at.y >= first && at.x < end_x && at.y < end_y)) continue;
    const int to_x = static_cast<int>(at.x);
    const int to_y = static_cast<int>(at.y);
    // A point between four pixels is hidden if it is clearly behind the farthest of them.
    if (depths_.reach(to_x, to_y) <= at.depth * nearer_) continue;
    const Sample found =
        sample<interpolation>(other_, to_x - part_.first_column, to_y - part_.first_row,
                              static_cast<float>(at.x - to_x), static_cast<float>(at.y - to_y),
                              static_cast<float>(at.along_x), static_cast<float>(at.along_y));
    out.is_seen[i] = 1;
    out.reference[i] = intensity - middle_intensity;
    out.other[i] = found.intensity - middle_intensity;
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

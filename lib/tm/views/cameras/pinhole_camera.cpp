#include "tm/views/cameras/pinhole_camera.h"

#include <Eigen/LU>

namespace transformesh {

Vec3 PinholeCamera::center() const { return -(rotation.transpose() * translation); }

Vec3 PinholeCamera::ray(double x, double y) const {
  return rotation.transpose() * (intrinsics.inverse() * Vec3(x, y, 1));
}

Projection PinholeCamera::projection() const {
  Projection projection;
  projection.leftCols<3>() = intrinsics * rotation;
  projection.col(3) = intrinsics * translation;
  return projection;
}

double PinholeCamera::focal_length() const { return (intrinsics(0, 0) + intrinsics(1, 1)) / 2; }

PinholeCamera PinholeCamera::shrunk(double factor) const {
  // Pixel 0 reaches from -1/2 to 1/2, so corners scale, not centres.
  PinholeCamera camera = *this;
  camera.intrinsics.topRows<2>() /= factor;
  camera.intrinsics(0, 2) += 0.5 / factor - 0.5;
  camera.intrinsics(1, 2) += 0.5 / factor - 0.5;
  return camera;
}

}  // namespace transformesh

#include "transformesh/pinhole_camera.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <vector>

#include "raster/camera.h"
#include "transformesh/errors.h"

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
  // Pixel 0 extends from -1/2 to 1/2. The corner of the image is therefore at -1/2, before and
  // after shrinking.
  PinholeCamera camera = *this;
  camera.intrinsics.topRows<2>() /= factor;
  camera.intrinsics(0, 2) += 0.5 / factor - 0.5;
  camera.intrinsics(1, 2) += 0.5 / factor - 0.5;
  return camera;
}

PinholeCamera PinholeCamera::mirrored() const {
  PinholeCamera camera = *this;
  camera.rotation.leftCols<2>() *= -1;
  camera.translation *= -1;
  return camera;
}

Vec3 viewed_point(std::span<const PinholeCamera> cameras) {
  Vec3 mean = Vec3::Zero();
  for (const PinholeCamera& camera : cameras) {
    mean += camera.center() / static_cast<double>(cameras.size());
  }

  // The result is the point with the least sum of squared distances from the viewing axes. Each
  // squared distance is a quadratic form. The sum of the forms is minimal where its derivative is
  // zero.
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Vec3 moment = Vec3::Zero();
  for (const PinholeCamera& camera : cameras) {
    const Vec3 axis = camera.rotation.row(2).normalized();
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - axis * axis.transpose();
    sum += across;
    moment += across * (camera.center() - mean);
  }

  // Along directions in which the sum is constant, as for parallel axes, the result is the mean of
  // the camera centers.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sum);
  Vec3 offset = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vec3 direction = solver.eigenvectors().col(i);
    const double stiffness = solver.eigenvalues()[i];
    if (stiffness > 1e-9 * static_cast<double>(cameras.size())) {
      offset += direction * (direction.dot(moment) / stiffness);
    }
  }
  return mean + offset;
}

double pixel_size(std::span<const PinholeCamera> cameras, const Vec3& point) {
  std::vector<double> sizes;
  for (const PinholeCamera& camera : cameras) {
    const double depth = camera.rotation.row(2).dot(point) + camera.translation.z();
    if (depth > 0) sizes.push_back(depth / camera.focal_length());
  }
  if (sizes.empty()) throw InputError("the scene's center is not in front of any camera");
  std::sort(sizes.begin(), sizes.end());
  const std::size_t middle = sizes.size() / 2;
  return sizes.size() % 2 == 1 ? sizes[middle] : (sizes[middle - 1] + sizes[middle]) / 2;
}

}  // namespace transformesh

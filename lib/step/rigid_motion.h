/// Rigid motions, and the least-squares motion that brings points into planes.
/// Reference: Chen & Medioni, "Object modelling by registration of multiple range images", Image
/// and Vision Computing 10(3), 1992.
#pragma once

#include <Eigen/Core>
#include <array>

#include "transformesh/mesh.h"

namespace transformesh {

/// Maps x to rotation * x + translation.
struct RigidMotion {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Vec3 translation = Vec3::Zero();

  Vec3 operator()(const Vec3& point) const { return rotation * point + translation; }
};

/// Returns the motion that applies `first` and then `second`. The rotation is made orthonormal
/// again, so that rounding does not add up.
RigidMotion compose(const RigidMotion& second, const RigidMotion& first);

/// Angle of a rotation in degrees, from 0 to 180.
double angle_deg_of(const Eigen::Matrix3d& rotation);

/// Normal equations of the distances of points from planes under a small motion, linearized.
/// Points are taken relative to their center and in units of their mean size, so that turning and
/// moving weigh alike.
class PlaneEquations {
 public:
  PlaneEquations(const Vec3& center, double size) : center_(center), size_(size) {}

  /// `distance` is that of the plane from the point, along the unit normal of the plane.
  void add(const Vec3& point, const Vec3& normal, double distance, double weight);

  struct Solution {
    RigidMotion motion;
    double stability = 0;  ///< square root of the least over the largest eigenvalue
  };
  /// Solves the equations. Directions in which nothing resists stay as they are. Deterministic.
  Solution solve() const;

 private:
  using Row = std::array<double, 6>;

  Vec3 center_;
  double size_;
  std::array<Row, 6> matrix_{};
  Row right_{};
};

}  // namespace transformesh

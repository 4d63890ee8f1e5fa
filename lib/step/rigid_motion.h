/// Rigid motions, and the rigid motion that minimizes the squared distances of points from planes.
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

/// Returns the motion that applies `first` and then `second`. The rotation is orthonormalized, so
/// that rounding errors do not accumulate.
RigidMotion compose(const RigidMotion& second, const RigidMotion& first);

/// Returns the angle of a rotation in degrees, in [0, 180].
double angle_deg_of(const Eigen::Matrix3d& rotation);

/// Normal equations for the small rigid motion that minimizes the squared distances of points from
/// planes, linearized in the rotation. Coordinates are relative to `center` and in units of `size`,
/// so that rotation and translation have similar weights.
class PlaneEquations {
 public:
  PlaneEquations(const Vec3& center, double size) : center_(center), size_(size) {}

  /// Adds a pair. `distance` is the signed distance from the point to the plane along its unit
  /// normal.
  void add(const Vec3& point, const Vec3& normal, double distance, double weight);

  struct Solution {
    RigidMotion motion;
    double stability = 0;  ///< square root of smallest / largest eigenvalue; 0 if undetermined
  };
  /// Solves the equations. Motions that the planes do not determine, such as the rotation of a
  /// sphere, are zero. Deterministic.
  Solution solve() const;

 private:
  using Row = std::array<double, 6>;

  Vec3 center_;
  double size_;
  std::array<Row, 6> matrix_{};
  Row right_{};
};

}  // namespace transformesh

/// The sum of squared distances of a point from planes, each with a weight. Reference: Garland &
/// Heckbert, "Surface simplification using quadric error metrics", SIGGRAPH 1997.
#pragma once

#include <Eigen/Cholesky>

#include "transformesh/mesh.h"

namespace transformesh {

class Quadric {
 public:
  Quadric() = default;
  /// The plane through a point with a unit normal.
  Quadric(const Vec3& point, const Vec3& normal, double weight)
      : matrix_(weight * normal * normal.transpose()),
        linear_(-weight * normal.dot(point) * normal),
        constant_(weight * normal.dot(point) * normal.dot(point)) {}

  Quadric& operator+=(const Quadric& other) {
    matrix_ += other.matrix_;
    linear_ += other.linear_;
    constant_ += other.constant_;
    return *this;
  }
  friend Quadric operator+(Quadric a, const Quadric& b) { return a += b; }

  double at(const Vec3& p) const {
    const double sum = p.dot(matrix_ * p) + 2 * linear_.dot(p) + constant_;
    return sum > 0 ? sum : 0;
  }
  /// Where it is least. In directions in which it hardly changes, that is near `start`: by iterated
  /// Tikhonov regularization.
  Vec3 least_near(const Vec3& start) const {
    constexpr double stiffness = 1e-3;
    constexpr int steps = 4;
    const double trace = matrix_.trace();
    if (!(trace > 0)) return start;
    const Eigen::Matrix3d stiff = matrix_ + stiffness * trace * Eigen::Matrix3d::Identity();
    const auto factors = stiff.ldlt();
    Vec3 point = start;
    for (int step = 0; step < steps; ++step) point -= factors.solve(matrix_ * point + linear_);
    return point;
  }

 private:
  Eigen::Matrix3d matrix_ = Eigen::Matrix3d::Zero();
  Vec3 linear_ = Vec3::Zero();
  double constant_ = 0;
};

}  // namespace transformesh

/// The sum of squared distances of a point from planes, each with a weight. Reference: Garland &
/// Heckbert, "Surface simplification using quadric error metrics", SIGGRAPH 1997.
#pragma once

#include <Eigen/Eigenvalues>

#include "transformesh/mesh.h"

namespace transformesh {

class Quadric {
 public:
  Quadric() = default;
  /// Makes the quadric of the plane through 0 with the unit normal `normal`.
  Quadric(const Vec3& normal, double weight) : matrix_(weight * normal * normal.transpose()) {}

  Quadric& operator+=(const Quadric& other) {
    matrix_ += other.matrix_;
    linear_ += other.linear_;
    constant_ += other.constant_;
    return *this;
  }
  friend Quadric operator+(Quadric a, const Quadric& b) { return a += b; }

  /// Returns the quadric for positions relative to `origin` instead of 0.
  Quadric relative_to(const Vec3& origin) const {
    Quadric moved = *this;
    moved.linear_ += matrix_ * origin;
    moved.constant_ += origin.dot(matrix_ * origin + 2 * linear_);
    return moved;
  }

  double at(const Vec3& p) const {
    const double sum = p.dot(matrix_ * p) + 2 * linear_.dot(p) + constant_;
    return sum > 0 ? sum : 0;
  }
  /// Returns the point with the least value. Among points with nearly equal values, returns the one
  /// nearest to `start`. Uses the pseudoinverse, and steps that correct its rounding errors.
  Vec3 least_near(const Vec3& start) const {
    // Eigenvalues below this fraction of the largest eigenvalue count as 0; chosen by hand, not
    // measured.
    constexpr double least_share = 1e-4;
    constexpr int steps = 3;  // number of correction steps; chosen by hand, not measured
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix_);
    const Vec3& values = solver.eigenvalues();
    if (!(values[2] > 0)) return start;
    Eigen::Matrix3d inverse = Eigen::Matrix3d::Zero();
    for (int i = 0; i < 3; ++i)
      if (values[i] > least_share * values[2]) {
        const Vec3 axis = solver.eigenvectors().col(i);
        inverse += axis * axis.transpose() / values[i];
      }
    Vec3 point = start;
    for (int step = 0; step < steps; ++step) point -= inverse * (matrix_ * point + linear_);
    return point;
  }

 private:
  Eigen::Matrix3d matrix_ = Eigen::Matrix3d::Zero();
  Vec3 linear_ = Vec3::Zero();
  double constant_ = 0;
};

}  // namespace transformesh

#include "step/rigid_motion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/elementary/arctangent.h"
#include "transformesh/transform.h"

namespace transformesh {
namespace {

using Row = std::array<double, 6>;
using Square = std::array<Row, 6>;

/// Eigenvalues below this fraction of the largest one count as 0. In theory, an undetermined
/// motion, such as the rotation of a sphere, has the eigenvalue 0. In practice, rounding errors
/// make this eigenvalue slightly different from 0. A larger fraction would discard motions that are
/// determined only by features of a thousandth of the size of the object.
constexpr double least_eigenvalue = 1e-10;
/// Number of sweeps. Jacobi's method for 6 x 6 matrices needs 5 to 7 for full accuracy.
constexpr int sweeps = 12;
constexpr double degrees = 180 / std::numbers::pi;

struct Eigensystem {
  /// The symmetric matrix; after the last sweep it is diagonal and contains the eigenvalues.
  Square matrix;
  Square vectors;  ///< eigenvectors, one per column
};

/// Applies a Jacobi rotation to the columns p and q.
void turn_columns(Square& matrix, std::size_t p, std::size_t q, double cosine, double sine) {
  for (Row& row : matrix) {
    const double a = row[p], b = row[q];
    row[p] = cosine * a - sine * b;
    row[q] = sine * a + cosine * b;
  }
}

void turn_rows(Square& matrix, std::size_t p, std::size_t q, double cosine, double sine) {
  for (std::size_t i = 0; i < 6; ++i) {
    const double a = matrix[p][i], b = matrix[q][i];
    matrix[p][i] = cosine * a - sine * b;
    matrix[q][i] = sine * a + cosine * b;
  }
}

/// Makes the entry (p, q) zero by a Jacobi rotation.
void annihilate(Eigensystem& system, std::size_t p, std::size_t q) {
  Square& a = system.matrix;
  if (a[p][q] == 0) return;
  const double ratio = (a[q][q] - a[p][p]) / (2 * a[p][q]);
  if (!std::isfinite(ratio * ratio)) return;
  const double tangent = (ratio < 0 ? -1 : 1) / (std::abs(ratio) + std::sqrt(ratio * ratio + 1));
  const double cosine = 1 / std::sqrt(tangent * tangent + 1);
  turn_columns(a, p, q, cosine, tangent * cosine);
  turn_rows(a, p, q, cosine, tangent * cosine);
  turn_columns(system.vectors, p, q, cosine, tangent * cosine);
}

/// Finds eigenvalues by the cyclic Jacobi method (Golub & Van Loan, "Matrix computations", 4th ed.,
/// 2013, section 8.5). Plain loops make the order of additions the same on every machine.
Eigensystem eigensystem_of(const Square& matrix) {
  Eigensystem system{matrix, {}};
  for (std::size_t i = 0; i < 6; ++i) system.vectors[i][i] = 1;
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (std::size_t p = 0; p < 6; ++p)
      for (std::size_t q = p + 1; q < 6; ++q) annihilate(system, p, q);
  return system;
}

RigidMotion rotation_by(const Vec3& vector) {
  const double angle = vector.norm();
  if (angle == 0) return {};
  return {rotation_about(vector, angle * degrees).topLeftCorner<3, 3>(), Vec3::Zero()};
}

}  // namespace

RigidMotion compose(const RigidMotion& second, const RigidMotion& first) {
  const Eigen::Quaterniond turn(Eigen::Matrix3d(second.rotation * first.rotation));
  return {turn.normalized().toRotationMatrix(), second(first.translation)};
}

double angle_deg_of(const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond turn(rotation);
  return 2 * elementary::atan2(turn.vec().norm(), std::abs(turn.w())) * degrees;
}

void PlaneEquations::add(const Vec3& point, const Vec3& normal, double distance, double weight) {
  const Vec3 turning = ((point - center_) / size_).cross(normal);
  const Row row{turning.x(), turning.y(), turning.z(), normal.x(), normal.y(), normal.z()};
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) matrix_[i][j] += weight * row[i] * row[j];
    right_[i] += weight * row[i] * distance / size_;
  }
}

PlaneEquations::Solution PlaneEquations::solve() const {
  const Eigensystem system = eigensystem_of(matrix_);
  double least = system.matrix[0][0], most = least;
  for (std::size_t k = 1; k < 6; ++k) {
    least = std::min(least, system.matrix[k][k]);
    most = std::max(most, system.matrix[k][k]);
  }
  Solution solution;
  if (!(most > 0)) return solution;
  solution.stability = std::sqrt(std::max(least, 0.0) / most);

  Row unknowns{};
  for (std::size_t k = 0; k < 6; ++k) {
    if (system.matrix[k][k] <= least_eigenvalue * most) continue;
    double along = 0;
    for (std::size_t i = 0; i < 6; ++i) along += system.vectors[i][k] * right_[i];
    for (std::size_t i = 0; i < 6; ++i)
      unknowns[i] += system.vectors[i][k] * along / system.matrix[k][k];
  }
  solution.motion = rotation_by({unknowns[0], unknowns[1], unknowns[2]});
  const Vec3 way = size_ * Vec3(unknowns[3], unknowns[4], unknowns[5]);
  solution.motion.translation = center_ + way - solution.motion.rotation * center_;
  return solution;
}

}  // namespace transformesh

#include "flow/relaxation.h"

#include <numbers>
#include <utility>

#include "transformesh/errors.h"

namespace transformesh {
namespace {

/// The diagonal coefficient of the method. With 1 - 1 / sqrt(2) it is L-stable and of order 2; the
/// other solution, 1 + 1 / sqrt(2), has an error 34 times as large.
constexpr double diagonal = 1 - 1 / std::numbers::sqrt2;

[[noreturn]] void refuse() {
  throw GoalError(
      "the equations of the step have no solution in double precision: the span is too long, or "
      "the coordinates are too small or too large");
}

}  // namespace

Relaxation::Relaxation(const Unknowns& unknowns, Eigen::VectorXd masses, const Matrix& stiffness,
                       double span)
    : unknowns_(unknowns), masses_(std::move(masses)), span_(span) {
  if (unknowns_.vertex_of.empty()) return;
  Matrix matrix = diagonal * span * stiffness;
  matrix.diagonal() += masses_;
  factors_.compute(matrix);
  if (factors_.info() != Eigen::Success) refuse();
}

/// Solve (M + g span K) k1 = M b and (M + g span K) k2 = M b - (1 - g) span K k1 for the stages k1
/// and k2, where g is `diagonal`. The first equation gives K k1.
Relaxation::Rows Relaxation::solved(const Rows& rates) const {
  const Rows right = masses_.asDiagonal() * rates;
  const Rows first = factors_.solve(right);
  const Rows change = masses_.asDiagonal() * first - right;
  const Rows second = factors_.solve(right + (1 - diagonal) / diagonal * change);
  Rows result = span_ * ((1 - diagonal) * first + diagonal * second);
  if (!result.allFinite()) refuse();
  return result;
}

std::vector<Vec3> Relaxation::after(const std::vector<Vec3>& rates) const {
  std::vector<Vec3> result(rates.size(), Vec3::Zero());
  const std::vector<Index>& vertices = unknowns_.vertex_of;
  if (vertices.empty()) return result;
  Rows rows(vertices.size(), 3);
  for (std::size_t row = 0; row < vertices.size(); ++row)
    rows.row(static_cast<Eigen::Index>(row)) = rates[vertices[row]].transpose();
  rows = solved(rows);
  for (std::size_t row = 0; row < vertices.size(); ++row)
    result[vertices[row]] = rows.row(static_cast<Eigen::Index>(row)).transpose();
  return result;
}

std::vector<double> Relaxation::after(const std::vector<double>& rates) const {
  std::vector<double> result(rates.size(), 0);
  const std::vector<Index>& vertices = unknowns_.vertex_of;
  if (vertices.empty()) return result;
  Rows rows(vertices.size(), 1);
  for (std::size_t row = 0; row < vertices.size(); ++row)
    rows(static_cast<Eigen::Index>(row), 0) = rates[vertices[row]];
  rows = solved(rows);
  for (std::size_t row = 0; row < vertices.size(); ++row)
    result[vertices[row]] = rows(static_cast<Eigen::Index>(row), 0);
  return result;
}

}  // namespace transformesh

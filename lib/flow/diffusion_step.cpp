#include "flow/diffusion_step.h"

#include <Eigen/SparseCholesky>

#include "transformesh/errors.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

/// Solves a linear system for the columns of `right`. Throws GoalError if the result is not finite.
template <class Right>
Right solution(const Matrix& matrix, const Right& right) {
  const Eigen::SimplicialLDLT<Matrix> factors(matrix);
  if (factors.info() == Eigen::Success) {
    Right result = factors.solve(right);
    if (result.allFinite()) return result;
  }
  throw GoalError(
      "the equations of the step have no solution in double precision: the span is too long, or "
      "the coordinates are too small or too large");
}

}  // namespace

DiffusionStep::DiffusionStep(const Mesh& mesh)
    : mesh_(mesh),
      laplacian_(cotangent_laplacian(mesh, CotangentBounds::each_triangle)),
      row_of_(mesh.positions.size(), no_index) {
  for (std::size_t v = 0; v < row_of_.size(); ++v) {
    const bool is_border = laplacian_.is_border[v] != 0;
    border_count_ += is_border;
    if (is_border || !(laplacian_.areas[v] > 0)) continue;
    row_of_[v] = static_cast<Index>(vertex_of_.size());
    vertex_of_.push_back(static_cast<Index>(v));
  }
}

/// Returns -L, restricted to the free vertices. Fixed neighbors contribute to the diagonal only.
DiffusionStep::Matrix DiffusionStep::stiffness() const {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(4 * laplacian_.edges.size());
  for (const auto& [from, to, weight] : laplacian_.edges) {
    const auto a = static_cast<int>(row_of_[from]), b = static_cast<int>(row_of_[to]);
    const bool is_a_free = row_of_[from] != no_index, is_b_free = row_of_[to] != no_index;
    if (is_a_free) entries.emplace_back(a, a, weight / 2);
    if (is_b_free) entries.emplace_back(b, b, weight / 2);
    if (!is_a_free || !is_b_free) continue;
    entries.emplace_back(a, b, -weight / 2);
    entries.emplace_back(b, a, -weight / 2);
  }
  const auto size = static_cast<Eigen::Index>(vertex_of_.size());
  Matrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

std::vector<Vec3> DiffusionStep::second_order(double span) const {
  std::vector<Vec3> result(mesh_.positions.size(), Vec3::Zero());
  if (vertex_of_.empty()) return result;
  // For the displacements d the equation is (M - span L) d = span L p.
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3>;
  Rows right = Rows::Zero(static_cast<Eigen::Index>(vertex_of_.size()), 3);
  for (const auto& [from, to, weight] : laplacian_.edges) {
    const Vec3 pull = span * (weight / 2) * (mesh_.positions[to] - mesh_.positions[from]);
    if (row_of_[from] != no_index) right.row(row_of_[from]) += pull.transpose();
    if (row_of_[to] != no_index) right.row(row_of_[to]) -= pull.transpose();
  }
  Matrix matrix = span * stiffness();
  for (std::size_t row = 0; row < vertex_of_.size(); ++row)
    matrix.coeffRef(static_cast<int>(row), static_cast<int>(row)) +=
        laplacian_.areas[vertex_of_[row]];
  const Rows solved = solution(matrix, right);
  for (std::size_t row = 0; row < vertex_of_.size(); ++row)
    result[vertex_of_[row]] = solved.row(static_cast<Eigen::Index>(row));
  return result;
}

std::vector<Vec3> DiffusionStep::curvature_vectors() const {
  std::vector<Vec3> vectors(mesh_.positions.size(), Vec3::Zero());
  for (const auto& [from, to, weight] : laplacian_.edges) {
    const Vec3 pull = weight / 2 * (mesh_.positions[to] - mesh_.positions[from]);
    vectors[from] += pull;
    vectors[to] -= pull;
  }
  for (std::size_t v = 0; v < vectors.size(); ++v)
    vectors[v] = row_of_[v] == no_index ? Vec3::Zero() : Vec3(vectors[v] / laplacian_.areas[v]);
  return vectors;
}

Eigen::VectorXd DiffusionStep::curvature_sums() const {
  const std::vector<Vec3> vectors = curvature_vectors();
  const std::vector<Vec3> normals = vertex_normals(mesh_);
  Eigen::VectorXd sums(static_cast<Eigen::Index>(vertex_of_.size()));
  for (std::size_t row = 0; row < vertex_of_.size(); ++row) {
    const Index v = vertex_of_[row];
    sums[static_cast<Eigen::Index>(row)] = -vectors[v].dot(normals[v]);
  }
  return sums;
}

std::vector<double> DiffusionStep::fourth_order(double span) const {
  std::vector<double> result(mesh_.positions.size(), 0);
  if (vertex_of_.empty()) return result;
  Eigen::VectorXd areas(static_cast<Eigen::Index>(vertex_of_.size()));
  for (std::size_t row = 0; row < vertex_of_.size(); ++row)
    areas[static_cast<Eigen::Index>(row)] = laplacian_.areas[vertex_of_[row]];
  const Matrix laplacian = stiffness();
  const Eigen::VectorXd right = -(laplacian * curvature_sums());
  Matrix matrix = span * (laplacian * areas.cwiseInverse().asDiagonal() * laplacian);
  for (int row = 0; row < areas.size(); ++row) matrix.coeffRef(row, row) += areas[row];
  const Eigen::VectorXd solved = solution(matrix, right);
  for (std::size_t row = 0; row < vertex_of_.size(); ++row)
    result[vertex_of_[row]] = solved[static_cast<Eigen::Index>(row)];
  return result;
}

}  // namespace transformesh

/// Implicit steps of diffusion on a surface, as sparse linear systems. Their matrices are symmetric
/// and positive definite for any span, and are factorized without pivoting: deterministic.
#pragma once

#include <Eigen/Sparse>
#include <vector>

#include "mesh/cotangent_laplacian.h"

namespace transformesh {

/// The equations of one mesh. Vertices on borders, or without area around them, are fixed; all
/// others are unknowns.
class DiffusionStep {
 public:
  explicit DiffusionStep(const Mesh& mesh);

  std::size_t border_count() const { return border_count_; }

  /// Returns at each vertex the inward normal times the sum of the principal curvatures; zero at
  /// fixed vertices.
  std::vector<Vec3> curvature_vectors() const;
  /// Solves (M - span L) x = M p for the positions x after a step of mean-curvature flow. Here p
  /// are the positions, M is the diagonal matrix of vertex areas, and L the cotangent matrix
  /// without areas. Returns x - p.
  std::vector<Vec3> second_order(double span) const;
  /// Solves (M + span L inverse(M) L) v = L h for the speeds v of surface diffusion along the
  /// normals, where h is the sum of the principal curvatures.
  std::vector<double> fourth_order(double span) const;

 private:
  using Matrix = Eigen::SparseMatrix<double>;

  Matrix stiffness() const;
  Eigen::VectorXd curvature_sums() const;

  const Mesh& mesh_;
  CotangentLaplacian laplacian_;
  std::vector<Index> row_of_;     ///< per vertex; no_index if it is fixed
  std::vector<Index> vertex_of_;  ///< per row
  std::size_t border_count_ = 0;
};

}  // namespace transformesh

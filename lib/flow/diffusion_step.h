/// Implicit steps of diffusion on a surface, as sparse linear systems. Their matrices are symmetric
/// and positive definite for any span, and are factorized without pivoting: deterministic.
#pragma once

#include <Eigen/Sparse>
#include <vector>

#include "mesh/cotangent_laplacian.h"

namespace transformesh {

/// Equations of the vertices that are free to move. Others, on borders or without area, are fixed.
class DiffusionStep {
 public:
  explicit DiffusionStep(const Mesh& mesh);

  std::size_t border_count() const { return border_count_; }

  /// Returns the sum of the principal curvatures times the inward normal at each vertex; 0 at fixed
  /// ones.
  std::vector<Vec3> curvature_vectors() const;
  /// Solves (M - span L) x = M p for the positions x after a step of mean-curvature flow. Positions
  /// are p, areas M, and L is the Laplacian without the areas. Returns x - p.
  std::vector<Vec3> second_order(double span) const;
  /// Solves (M + span L inverse(M) L) v = L h for the speeds v along the normals of surface
  /// diffusion, where h is the sum of the principal curvatures.
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

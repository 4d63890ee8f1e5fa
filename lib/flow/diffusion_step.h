/// Equations of diffusion on a surface: mean-curvature flow and surface diffusion. Cotangents,
/// areas and normals are those of one mesh. Therefore the equations are linear in the movement of
/// the vertices.
#pragma once

#include <Eigen/Sparse>
#include <vector>

#include "flow/relaxation.h"
#include "mesh/cotangent_laplacian.h"

namespace transformesh {

/// The equations of diffusion on one mesh. Vertices on borders, or without area around them, are
/// fixed; all others are unknowns. In the formulas, M is the diagonal matrix of vertex areas, and L
/// the cotangent matrix without areas.
class DiffusionStep {
 public:
  explicit DiffusionStep(const Mesh& mesh);

  std::size_t border_count() const { return border_count_; }

  /// Returns inverse(M) L p for these positions p. For the positions of the mesh, this is at each
  /// vertex the inward normal times the sum of the principal curvatures. Zero at fixed vertices.
  std::vector<Vec3> curvature_vectors(const std::vector<Vec3>& positions) const;
  /// Returns the equations M y' = M b + L y of mean-curvature flow, where b are the curvature
  /// vectors at the start of the span. Pre: the object outlives the result.
  Relaxation second_order(double span) const;

  /// Returns the speeds of surface diffusion along the normals, inverse(M) L h. The mesh must be at
  /// `offsets` along its normals from the surface whose speeds are wanted. The sum of the principal
  /// curvatures of that surface is h = h0 + inverse(M) L offsets, where h0 is that of the mesh.
  /// Zero at fixed vertices.
  std::vector<double> diffusion_speeds(const std::vector<double>& offsets) const;
  /// Returns the equations M y' = M b - L inverse(M) L y of surface diffusion, where b are the
  /// speeds at the start of the span. Pre: the object outlives the result.
  Relaxation fourth_order(double span) const;

 private:
  using Matrix = Eigen::SparseMatrix<double>;

  Matrix stiffness() const;
  Eigen::VectorXd areas() const;
  Eigen::VectorXd curvature_sums() const;

  const Mesh& mesh_;
  CotangentLaplacian laplacian_;
  Unknowns unknowns_;
  std::size_t border_count_ = 0;
};

}  // namespace transformesh

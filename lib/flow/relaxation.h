/// A step of the linear equations M y' = M b - K y from y = 0 with constant rates b. The mass
/// matrix M is diagonal. The stiffness matrix K is symmetric and positive semidefinite. The method
/// is the diagonally implicit Runge-Kutta method of two stages and order 2 that is L-stable: it
/// damps what changes fast, however long the span is. Both stages share one sparse factorization
/// without pivoting: deterministic. Reference: Alexander, "Diagonally implicit Runge-Kutta methods
/// for stiff O.D.E.'s", SIAM Journal on Numerical Analysis 14, 1977.
#pragma once

#include <Eigen/SparseCholesky>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// The vertices of a mesh that are unknowns of a system of equations. All other vertices are fixed.
struct Unknowns {
  /// For each vertex, its row in the equations; no_index if the vertex is fixed.
  std::vector<Index> row_of;
  std::vector<Index> vertex_of;  ///< for each row of the equations, its vertex
};

class Relaxation {
 public:
  using Matrix = Eigen::SparseMatrix<double>;
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>;

  /// Factorizes the equations. Pre: `unknowns` outlives the object. Throws GoalError if the
  /// equations have no solution in double precision.
  Relaxation(const Unknowns& unknowns, Eigen::VectorXd masses, const Matrix& stiffness,
             double span);

  /// Return the solution y at the end of the span for the rates b. Both have one entry per vertex;
  /// y is zero at fixed vertices. Throw GoalError if the result is not finite.
  std::vector<Vec3> after(const std::vector<Vec3>& rates) const;
  std::vector<double> after(const std::vector<double>& rates) const;

 private:
  Rows solved(const Rows& rates) const;

  const Unknowns& unknowns_;
  Eigen::VectorXd masses_;
  double span_;
  Eigen::SimplicialLDLT<Matrix> factors_;
};

}  // namespace transformesh

/// One step of an explicit Runge-Kutta method for the vertices of a surface: the motion is
/// evaluated at the stages on the same connectivity. The difference to an embedded method of lower
/// order estimates the local error.
#pragma once

#include <vector>

#include "transformesh/evolve_in_time.h"
#include "transformesh/motion.h"

namespace transformesh {

struct Integrated {
  std::vector<Vec3> displacements;
  double error = 0;  ///< largest difference of a vertex to the embedded method, in input units
};

/// A step from one point of time. Its first stage is evaluated once, for any number of spans.
class Integration {
 public:
  /// Pre: `motion` and `mesh` outlive the object, and `mesh` does not change.
  Integration(const Motion& motion, const Mesh& mesh, double time, Integrator integrator,
              const Progress& progress);

  /// Returns the velocities at the beginning of the step; empty if the motion has an integrator of
  /// its own.
  const std::vector<Vec3>& initial_velocities() const { return first_; }

  /// Returns the step over this span. Throws InputError if the motion returns another number of
  /// vectors than there are vertices, or one that is not finite. Euler's method and motions with
  /// their own integrator have no embedded method: `error` is 0.
  Integrated over(double span) const;

 private:
  std::vector<Vec3> velocities_at(double delay, const std::vector<Vec3>& offsets, double span,
                                  int stage) const;
  Integrated midpoint(double span) const;
  Integrated rk4(double span) const;

  const Motion& motion_;
  const Mesh& mesh_;
  double time_;
  Integrator integrator_;
  const Progress& progress_;
  std::vector<Vec3> first_;
};

/// Returns the order to which the error estimate of the embedded pair vanishes with the span: 2 for
/// midpoint, 3 for rk4.
int error_order(Integrator integrator);

/// Moves the vertices and computes normals again. Rounding, cleaning and remeshing are left to the
/// iteration. `mean_edge` is that of the mesh before, for the result.
DisplaceResult move_vertices(Mesh& mesh, const std::vector<Vec3>& displacements, double mean_edge);

}  // namespace transformesh

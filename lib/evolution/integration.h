/// One step of an explicit Runge-Kutta method for the vertices of a surface. All stages evaluate
/// the motion on the same connectivity. The difference from an embedded method of lower order
/// estimates the local error: Euler's method for midpoint, and midpoint for rk4. Reference: Hairer,
/// Norsett & Wanner, "Solving ordinary differential equations I", 2nd ed., 1993, section II.4.
/// Cost: 1, 2 or 4 evaluations of the motion.
#pragma once

#include <vector>

#include "transformesh/evolve_in_time.h"
#include "transformesh/motion.h"

namespace transformesh {

struct Integrated {
  std::vector<Vec3> displacements;
  double error = 0;  ///< largest distance of a vertex from its position by the embedded method
};

/// Runge-Kutta steps of different time spans from one point in time. The first stage is evaluated
/// once for all spans.
class Integration {
 public:
  /// Pre: `motion` and `mesh` outlive the object, and `mesh` does not change.
  Integration(const Motion& motion, const Mesh& mesh, double time, Integrator integrator,
              const Progress& progress);

  /// Returns the velocities at the beginning of the step; empty if the motion computes
  /// displacements itself.
  const std::vector<Vec3>& initial_velocities() const { return first_; }

  /// Returns the result of a step over this time span. Throws InputError if the number of vectors
  /// of the motion is not that of the vertices, or if a vector is not finite. `error` is 0 for
  /// Euler's method and for motions that compute displacements, since these have no embedded
  /// method.
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

/// Returns the exponent k of the error estimate, which is proportional to span^k for short spans: 2
/// for midpoint, 3 for rk4.
int error_order(Integrator integrator);

/// Moves the vertices and recomputes normals; does not round, clean or remesh. `mean_edge` is the
/// mean edge length before the movement, and is copied to the result.
DisplaceResult move_vertices(Mesh& mesh, const std::vector<Vec3>& displacements, double mean_edge);

}  // namespace transformesh

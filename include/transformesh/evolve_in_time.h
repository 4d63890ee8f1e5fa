/// Evolves a surface along a motion in physical time. In each step all vertices move for the same
/// span of time. Then clean() removes self-intersections and remesh() keeps the surface sampled.
///
/// The velocity is evaluated at the stages of the integrator on the same connectivity. A step that
/// changes the number of components or the genus is repeated with half the span while the span is
/// above `event_tolerance`. Guarantees of the result: iteration.h. The source is cleaned first, and
/// the result once more. Throws what the stages throw, with the number of the iteration; GoalError
/// if the span becomes too short to reach the end. The mesh is then that of the last good
/// iteration. Deterministic if the motion is. Reference for embedded pairs and the choice of the
/// span: Hairer, Norsett & Wanner, "Solving Ordinary Differential Equations I", 2nd ed., 1993,
/// section II.4.
#pragma once

#include "transformesh/evolve.h"
#include "transformesh/motion.h"

namespace transformesh {

/// Explicit Runge-Kutta methods of order 1, 2 and 4.
enum class Integrator { euler, midpoint, rk4 };

struct TimeOptions {
  double end = 1;   ///< the evolution lasts from time 0 to this; > 0
  double span = 0;  ///< duration of a step; 0: as long as `max_move` and `tolerance` permit
  Integrator integrator = Integrator::midpoint;
  /// Largest movement of a vertex in a step, relative to its mean edge; used if `span` is 0.
  double max_move = 0.5;
  /// Largest distance of a vertex from its position by the embedded method (Euler in midpoint,
  /// midpoint in rk4); input units; 0: no limit. Used only if `span` is 0.
  double tolerance = 0;
  /// Longer steps are repeated if the topology changes. 0: no step is; negative: `end` / 1000.
  double event_tolerance = -1;
  /// Restores the volume of each component after remeshing; offsets vertices along normals.
  bool keep_volume = false;
  std::string bodies = {};  ///< face column with the number of the body; bodies may not meet
  double gap = 0;           ///< least distance of two bodies; input units; > 0 with `bodies`
};

struct TimeResult {
  double time = 0;            ///< time at the end of this run
  EvolveResult evolution;     ///< `is_done`: the time `end` or the rule `until` was reached
  double volume = 0;          ///< volume of the result, in cubic input units
  double volume_drift = 0;    ///< volume change by remeshing; `keep_volume`: not restored
  double max_move = 0;        ///< largest movement of a vertex in a step, relative to its mean edge
  std::size_t held_back = 0;  ///< largest number of vertices held back by other bodies in one step
  std::size_t repeated = 0;   ///< steps repeated with a shorter span, including earlier runs
};

/// A resumed run replaces `document` by its saved state. `options.iteration.remesh` smooths by
/// default: set its `smoothing` to none to keep what the motion made.
TimeResult evolve_in_time(Document& document, const Motion& motion, const TimeOptions& time,
                          const EvolveOptions& options = {}, const LoopOptions& loop = {},
                          const Progress& progress = Progress());

/// Evolves a mesh in double precision.
TimeResult evolve_in_time(Mesh& mesh, const Motion& motion, const TimeOptions& time,
                          const EvolveOptions& options = {}, const LoopOptions& loop = {},
                          const Progress& progress = Progress());

}  // namespace transformesh

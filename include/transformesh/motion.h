/// A motion of a surface in physical time, which evolve() integrates.
///
///     const Motion rising{[](const Mesh& mesh, const Moment&, const Progress&) {
///       return std::vector<Vec3>(mesh.positions.size(), Vec3(0, 0, 1));
///     }};
///
/// A motion may depend on time, on the surface and on its vertex columns. It must be deterministic
/// if the evolution has to be.
#pragma once

#include <functional>
#include <vector>

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// The point of time for which a motion is evaluated.
struct Moment {
  double time = 0;  ///< time at this stage of the integrator
  double span = 0;  ///< duration of the whole step; 0 if the evolution has not chosen it yet
  int stage = 0;    ///< number of the stage within the step, from 0
};

/// Returns one vector per vertex.
using VectorField =
    std::function<std::vector<Vec3>(const Mesh& mesh, const Moment& moment, const Progress&)>;

struct Motion {
  VectorField velocity;  ///< input units per time
  /// If set, the motion has its own integrator, such as an implicit one: returns the displacement
  /// from `moment.time` to `moment.time + moment.span`, in input units. `velocity` and the
  /// integrator and tolerance of TimeOptions are then not used by evolve_in_time().
  VectorField displacement = {};
};

}  // namespace transformesh

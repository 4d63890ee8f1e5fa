/// Stores the velocities of a motion in the vertex columns vx, vy and vz, which column_velocities()
/// reads.
#pragma once

#include "transformesh/motion.h"

namespace transformesh {

/// Maximum and root mean square of the speeds of all vertices.
struct FlowSpeeds {
  double maximum = 0;
  double rms = 0;
};

/// Stores the velocities of the motion at `moment` in vertex columns. If the moment has a time span
/// and the motion computes displacements, velocities are these displacements divided by the span.
/// Throws InputError, naming the vertex, if a velocity is not finite.
FlowSpeeds add_flow_columns(Mesh& mesh, const Motion& motion, const Moment& moment,
                            const Progress& progress = Progress());

}  // namespace transformesh

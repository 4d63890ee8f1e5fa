/// Stores velocities of a motion as the vertex columns vx, vy and vz, which column_velocities()
/// reads.
#pragma once

#include "transformesh/motion.h"

namespace transformesh {

/// Maximum and root mean square of the lengths of all velocities.
struct FlowSpeeds {
  double maximum = 0;
  double rms = 0;
};

/// Stores the velocities at a moment. If the moment has a span and the motion computes
/// displacements, velocities are displacements over the span, divided by the span. Throws
/// InputError, naming the vertex, if a velocity is not finite.
FlowSpeeds add_flow_columns(Mesh& mesh, const Motion& motion, const Moment& moment,
                            const Progress& progress = Progress());

}  // namespace transformesh

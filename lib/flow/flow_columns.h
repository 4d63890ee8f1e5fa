/// Velocities of a motion as the vertex columns vx, vy and vz, which displace() and other programs
/// read.
#pragma once

#include "transformesh/motion.h"

namespace transformesh {

/// Sizes of the velocities, over all vertices.
struct FlowSpeeds {
  double maximum = 0;
  double rms = 0;
};

/// Writes the velocities at a moment. If the moment has a span and the motion its own integrator,
/// these are displacements over the span, divided by the span. Throws InputError with the vertex
/// for a velocity that is not finite.
FlowSpeeds add_flow_columns(Mesh& mesh, const Motion& motion, const Moment& moment,
                            const Progress& progress = Progress());

}  // namespace transformesh

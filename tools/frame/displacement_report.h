/// Notes on stderr about clamped movements of vertices.
#pragma once

#include "frame/run.h"
#include "support/counted.h"
#include "support/number.h"
#include "transformesh/displace.h"

namespace transformesh::tool {

/// Prints the number of clamped vertices, followed by `remedy`. Does nothing if no vertex was
/// clamped.
inline void note_clamped(const DisplaceResult& result, double alpha, const std::string& remedy,
                         Run& run) {
  if (result.clamped == 0) return;
  run.note("movements of " + std::to_string(result.clamped) + " of " +
           counted(run.document().mesh.positions.size(), "vertex") + " are clamped to " +
           text_of(alpha) + " of the mean edge at the vertex; the largest movement is " +
           significant(result.max_displacement, 3) + "; " + remedy);
}

}  // namespace transformesh::tool

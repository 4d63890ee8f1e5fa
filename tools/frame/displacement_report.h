/// The line on stderr if vertices could not move as far as they should.
#pragma once

#include "frame/run.h"
#include "support/counted.h"
#include "support/number.h"
#include "transformesh/displace.h"

namespace transformesh::tool {

/// `remedy` is what to do about it.
inline void note_clamped(const DisplaceResult& result, double alpha, const std::string& remedy,
                         Run& run) {
  if (result.clamped == 0) return;
  run.note(std::to_string(result.clamped) + " of " +
           counted(run.document().mesh.positions.size(), "vertex") + " clamped to " +
           text_of(alpha) + " of the mean edge at the vertex, " +
           significant(result.max_displacement, 3) + " at most; " + remedy);
}

}  // namespace transformesh::tool

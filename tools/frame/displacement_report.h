/// The entries of a report that all programs share which move vertices, and the line on stderr
/// where they could not go as far as they should.
#pragma once

#include "frame/column_notes.h"
#include "frame/run.h"
#include "support/counted.h"
#include "support/number.h"
#include "transformesh/displace.h"

namespace transformesh::tool {

inline void report_displacement(const DisplaceResult& result, Run& run) {
  run.report("moved", result.moved);
  run.report("clamped", result.clamped);
  run.report("max_displacement", result.max_displacement);
  run.report("rms_displacement", result.rms_displacement);
  run.report("max_clamp_share", result.max_clamp_share);
  run.report("mean_edge", result.mean_edge);
  note_new_normals(result.new_normals, run);
}

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

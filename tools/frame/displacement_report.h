/// The entries of a report that all programs share which move vertices.
#pragma once

#include "frame/run.h"
#include "tm/step/displace.h"

namespace transformesh::tool {

inline void report_displacement(const DisplaceResult& result, Run& run) {
  run.report("moved", result.moved);
  run.report("clamped", result.clamped);
  run.report("max_displacement", result.max_displacement);
  run.report("rms_displacement", result.rms_displacement);
  run.report("max_clamp_share", result.max_clamp_share);
  run.report("mean_edge", result.mean_edge);
}

}  // namespace transformesh::tool

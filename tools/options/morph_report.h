/// The report of tm-morph, and its last message.
#pragma once

#include <string>

#include "evolution/loop/iteration_text.h"
#include "evolution/morph_remedy.h"
#include "evolution/recorded_loops.h"
#include "frame/advice.h"
#include "frame/run.h"
#include "support/counted.h"
#include "support/number.h"
#include "transformesh/components.h"
#include "transformesh/measure.h"
#include "transformesh/morph.h"

namespace transformesh::tool {

inline std::string how(MorphStop stop) {
  if (stop == MorphStop::converged) return "converged";
  return stop == MorphStop::stalled ? "no longer improving" : "iteration limit reached";
}

/// Returns a message on what is wrong with the result of a morph, and how to remedy it. Returns an
/// empty text if nothing is wrong.
inline std::string fault_of(const MorphResult& result, const Program& program) {
  const std::string& fault = result.fault;
  if (fault.empty()) return fault;
  const bool was_limited = result.stop == MorphStop::iteration_limit;
  return fault + ": " +
         (was_limited ? "allow more with --iterations" : advice_for(result.cause, program));
}

inline std::string summary(const MorphResult& result, const Mesh& mesh, const Program& program) {
  const std::string fault = fault_of(result, program);
  return how(result.stop) + " after " + counted(result.iterations, "iteration") + ": " +
         in_short(mesh.faces.size(), result.topology) + ", rms distance " +
         significant(result.distances.to_target.rms, 3) + " to and " +
         significant(result.distances.from_target.rms, 3) + " from the target" +
         (fault.empty() ? "" : "; " + fault);
}

inline void report_morph(const MorphResult& result, Run& run) {
  Entries entries = entries_of(result);
  for (auto& [key, value] : entries)
    if (key == "fault") value = fault_of(result, run.program());
  run.report(entries);
  if (result.left_out > 0)
    run.note(counted(result.left_out, "component") + " of the target " +
             (result.left_out == 1 ? "is a cavity or lies in one, and is ignored"
                                   : "are cavities or lie in them, and are ignored") +
             ": an evolving surface cannot keep a cavity");
}

inline void report_tracking(const TrackResult& result, const Mesh& mesh, Run& run) {
  run.report("converged", result.converged == result.frames);
  run.report("frames", result.frames);
  run.report("converged_frames", result.converged);
  run.report("components", connected_components(mesh).components.size());
  run.report("mean_edge", edge_lengths(mesh).mean);
}

inline std::string summary(const TrackResult& result, const Mesh& mesh) {
  return counted(result.frames, "frame") + ", " + std::to_string(result.converged) +
         " converged: " + counted(mesh.faces.size(), "face");
}

}  // namespace transformesh::tool

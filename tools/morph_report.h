/// What tm-morph reports, and the line that it ends with.
#pragma once

#include <string>

#include "evolution/tracking.h"
#include "frame/run.h"
#include "mesh/components.h"
#include "mesh/measure.h"
#include "support/counted.h"

namespace transformesh::tool {

inline std::string how(MorphingStop stop) {
  if (stop == MorphingStop::converged) return "converged";
  return stop == MorphingStop::stalled ? "no longer improving" : "iteration limit reached";
}

/// The options that mend it; empty if there is nothing to mend.
inline std::string words_of(const MorphRemedy& remedy, const MorphingOptions& options) {
  // The longest edges are 1.5 times as long as the reference edge, which this halves.
  const std::string halved = significant(remedy.edge / 3, 2);
  switch (remedy.kind) {
    case RemedyKind::clean_target:
      return "the target is open, no manifold, or intersects itself, so that no surface without "
             "self-intersections lies on all of it: clean it with tm-clean, or close its holes "
             "with tm-fill";
    case RemedyKind::edges_at_narrow_places:
      return options.step.gap_edges == 0 ? "shorten edges at narrow places with --gap-edges 1.5"
                                         : "shorten all edges with --reference-edge " + halved;
    case RemedyKind::larger_source:
      return "begin with a source that overlaps all of the target, as tm-shape sphere --around "
             "makes it";
    case RemedyKind::shorter_edges:
      return "shorten edges with --reference-edge " + halved;
    case RemedyKind::none:
      break;
  }
  return {};
}

/// Returns the fault of a morph with the option that mends it; empty if there is none.
inline std::string fault_of(const MorphingResult& result, const MorphingOptions& options) {
  const std::string& fault = result.agreement.fault;
  if (fault.empty()) return fault;
  const bool was_limited = result.stop == MorphingStop::iteration_limit;
  return fault + ": " + (was_limited ? "take more --iterations" : words_of(result.remedy, options));
}

/// Calls it; adds to the message that the surface has vanished what mends that.
template <class Morph>
MorphingResult with_remedy(const MorphingOptions& options, const Morph& morph) {
  try {
    return morph();
  } catch (const VanishedError& error) {
    throw GoalError(std::string(error.what()) + ": " + words_of(error.remedy, options));
  }
}

inline std::string summary(const MorphingResult& result, const MorphingOptions& options,
                           const Mesh& mesh) {
  const std::string fault = fault_of(result, options);
  return how(result.stop) + " after " + counted(result.iterations, "iteration") + ": " +
         in_short(mesh.faces.size(), result.topology) + ", rms distance " +
         significant(result.distances.to_target.rms, 3) + " to and " +
         significant(result.distances.from_target.rms, 3) + " from the target" +
         (fault.empty() ? "" : "; " + fault);
}

inline void report_morph(const MorphingResult& result, const MorphingOptions& options, Run& run) {
  const MorphStepResult& distances = result.distances;
  run.report("converged", result.stop == MorphingStop::converged);
  run.report("stop", name_of(result.stop));
  run.report("iterations", result.iterations);
  run.report("components", result.topology.components);
  run.report("genus", result.topology.genus);
  run.report("rms_distance_to_target", distances.to_target.rms);
  run.report("max_distance_to_target", distances.to_target.maximum);
  run.report("rms_distance_from_target", distances.from_target.rms);
  run.report("max_distance_from_target", distances.from_target.maximum);
  if (result.agreement.to_target) {
    run.report("hausdorff_to_target", *result.agreement.to_target);
    run.report("hausdorff_from_target", *result.agreement.from_target);
  }
  if (result.expected) {
    run.report("target_components", result.expected->components);
    run.report("target_genus", result.expected->genus);
  }
  run.report("target_left_out", result.left_out);
  if (result.left_out > 0)
    run.note(counted(result.left_out, "component") + " of the target " +
             (result.left_out == 1 ? "bounds a cavity" : "bound cavities") +
             " or floats in one, and is no goal: a surface that evolves keeps no cavity");
  run.report("fault", fault_of(result, options));
  run.report("mean_edge", distances.displaced.mean_edge);
  run.report("aligned", result.aligned);
}

inline void report_tracking(const TrackingResult& result, const Mesh& mesh, Run& run) {
  run.report("converged", result.converged == result.frames);
  run.report("frames", result.frames);
  run.report("converged_frames", result.converged);
  run.report("components", connected_components(mesh).components.size());
  run.report("mean_edge", edge_lengths(mesh).mean);
}

inline std::string summary(const TrackingResult& result, const Mesh& mesh) {
  return counted(result.frames, "frame") + ", " + std::to_string(result.converged) +
         " converged: " + counted(mesh.faces.size(), "face");
}

}  // namespace transformesh::tool

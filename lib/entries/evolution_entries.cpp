// Report entries (names and values for reports and Python) of single steps of an evolution, and of
// whole evolutions.
#include "entries/entries.h"
#include "evolution/loop/iteration_text.h"
#include "evolution/recorded_loops.h"
#include "transformesh/displace.h"
#include "transformesh/evolve_in_time.h"
#include "transformesh/morph.h"
#include "transformesh/offset.h"

namespace transformesh {
namespace {

Entries entries_of(const Topology& topology) {
  return {{"components", topology.components}, {"genus", topology.genus}};
}

Entries distances_of(const MorphStepResult& result) {
  return {{"rms_distance_to_target", result.to_target.rms},
          {"max_distance_to_target", result.to_target.maximum},
          {"rms_distance_from_target", result.from_target.rms},
          {"max_distance_from_target", result.from_target.maximum}};
}

Entries ends_of(const EvolveResult& result) {
  Entries entries{{"stop", result.is_done ? "converged" : "iteration_limit"},
                  {"iterations", result.iterations}};
  append(entries, entries_of(result.last.topology));
  return entries;
}

Entries with_events(Entries entries, const EvolveResult& result) {
  if (result.event_count) entries.emplace_back("events", *result.event_count);
  return entries;
}

}  // namespace

Entries entries_of(const DisplaceResult& result) {
  return {{"moved", result.moved},
          {"clamped", result.clamped},
          {"max_displacement", result.max_displacement},
          {"rms_displacement", result.rms_displacement},
          {"max_clamp_share", result.max_clamp_share},
          {"mean_edge", result.mean_edge}};
}

Entries entries_of(const MorphStepResult& result) {
  Entries entries = distances_of(result);
  append(entries, entries_of(result.displaced));
  return entries;
}

Entries entries_of(const OffsetResult& result) {
  Entries entries{{"stop", !result.has_arrived ? "iteration_limit"
                           : result.has_missed ? "missed"
                                               : "converged"},
                  {"iterations", result.iterations}};
  append(entries, entries_of(result.topology));
  append(entries, {{"deviation_rms", result.deviation.rms},
                   {"deviation_max", result.deviation.most},
                   {"missed_max", result.deviation.missed},
                   {"edge", result.edge}});
  return entries;
}

Entries entries_of(const EvolveResult& result) {
  Entries entries = ends_of(result);
  append(entries, {{"clamped_iterations", result.clamped_iterations},
                   {"clamped_share", result.clamped_share},
                   {"max_displacement", result.last.displaced.max_displacement},
                   {"rms_displacement", result.last.displaced.rms_displacement}});
  return with_events(entries, result);
}

Entries entries_of(const TimeResult& result) {
  const EvolveResult& evolution = result.evolution;
  Entries entries = ends_of(evolution);
  append(entries, {{"time", result.time},
                   {"volume", result.volume},
                   {"volume_drift", result.volume_drift},
                   {"max_move", result.max_move},
                   {"held_back", result.held_back},
                   {"repeated_steps", result.repeated}});
  return with_events(entries, evolution);
}

Entries entries_of(const MorphResult& result) {
  Entries entries{{"converged", result.stop == MorphStop::converged},
                  {"stop", name_of(result.stop)},
                  {"iterations", result.iterations}};
  append(entries, entries_of(result.topology));
  append(entries, distances_of(result.distances));
  if (result.to_target)
    append(entries, {{"hausdorff_to_target", *result.to_target},
                     {"hausdorff_from_target", *result.from_target}});
  if (result.expected)
    append(entries, {{"target_components", result.expected->components},
                     {"target_genus", result.expected->genus}});
  append(entries, {{"target_left_out", result.left_out},
                   {"fault", result.fault},
                   {"mean_edge", result.distances.displaced.mean_edge},
                   {"aligned", result.aligned}});
  return entries;
}

}  // namespace transformesh

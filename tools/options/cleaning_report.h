/// The entries of tm-clean's report.
#pragma once

#include "clean/stitch/separate.h"
#include "frame/column_notes.h"
#include "frame/run.h"
#include "support/counted.h"
#include "support/number.h"
#include "transformesh/clean.h"
#include "transformesh/components.h"

namespace transformesh::tool {

/// A generalized winding number that is this close to where it rounds otherwise is worth a look.
constexpr double small_margin = 0.1;

inline void note_margin(const CleanResult& result, Run& run) {
  if (result.decided_by_number == 0 || result.least_margin >= small_margin) return;
  run.note("generalized winding numbers decided " + counted(result.decided_by_number, "part") +
           " of the open mesh, one of them by a margin of only " +
           shortest_text(result.least_margin));
}

inline void report_cleaning(const CleanResult& result, const SeparateResult& separated,
                            const Mesh& mesh, Run& run) {
  note_dropped_lists(result.dropped_columns, run);
  note_dropped_sources(result.dropped_source_points, source_of_step, run);
  note_margin(result, run);
  run.report("changed", result.changed || separated.separated_vertices > 0);
  run.report("pairs", result.pairs);
  run.report("pieces", result.pieces);
  run.report("cut_faces", result.cut_faces);
  run.report("removed_faces", result.removed_faces);
  run.report("new_vertices", result.new_vertices);
  run.report("copied_vertices", result.copied_vertices);
  run.report("patches", result.patches);
  run.report("decided_by_number", result.decided_by_number);
  run.report("least_margin", result.least_margin);
  run.report("rays", result.rays);
  run.report("dropped_components", result.dropped_components);
  run.report("rounding_repairs", result.rounding_repairs);
  run.report("rounding_places", result.rounding_places);
  run.report("rounding_faces", result.rounding_faces);
  run.report("rounding_pairs", result.rounding_pairs);
  run.report("rounding_level", result.rounding_level);
  run.report("rounding_displacement", result.rounding_displacement);
  run.report("rounding_spacings", result.rounding_spacings);
  run.report("separated_vertices", separated.separated_vertices);
  run.report("separation_refused", separated.refused_vertices);
  // They take a while to count.
  if (!run.shows_report()) return;
  const Components components = connected_components(mesh);
  run.report("components", components.components.size());
  run.report("genus", components.genus());
}

}  // namespace transformesh::tool

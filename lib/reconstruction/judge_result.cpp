#include "reconstruction/judge_result.h"

#include <utility>

#include "evolution/loop/stages.h"
#include "io/document/round_as_written.h"
#include "reconstruction/better_parts.h"
#include "reconstruction/start_comparison.h"
#include "reconstruction/surface_doubt.h"
#include "transformesh/components.h"

namespace transformesh {
namespace {

/// Farthest distance in pixels by which vertices move back onto a given initial mesh. Parts of that
/// mesh that are farther away belong to other parts of the object. Steps at scale 1 hardly correct
/// errors of that size.
constexpr double reach_px = 10;

}  // namespace

void ResultJudge::judge(Document& document, ReconstructionFaults faults,
                        ReconstructionResult& result, const Progress& progress) const {
  const bool is_given = options_.initial.is_given;
  const bool is_exploded = faults.exploded_at > 0;
  const SurfaceMeasures start =
      photographs_.measures(given_.mesh, is_given || is_exploded, progress);
  SurfaceMeasures end = start;
  if (is_exploded) {
    result.kept = faults.in_words({});
    keep_start(document, result);
  } else {
    end = photographs_.measures(document.mesh, true, progress);
    if (is_given) end = best_of(start, std::move(end), document, result, progress);
    // Faults of the sweeps are not faults of the given mesh.
    if (!result.kept.empty()) faults = {.is_at_rest = true};
  }
  result.first = start.windows;
  result.last = end.windows;
  result.first_agreement = start.mean_outline();
  result.agreement = end.mean_outline();
  result.fault = faults.in_words({result.first_agreement, result.agreement, end.doubt});
  set_doubt_column(document.mesh, end.doubt);
  result.disagreement = end.doubt.disagreement;
  result.noise_floor = end.doubt.floor;
  result.doubtful = end.doubt.share;
  result.doubtful_places = std::move(end.doubt.places);
}

// Brings those parts of the given mesh back that are at least as good as the result, or the whole
// given mesh. Returns the measures of the changed document.
SurfaceMeasures ResultJudge::best_of(const SurfaceMeasures& start, SurfaceMeasures end,
                                     Document& document, ReconstructionResult& result,
                                     const Progress& progress) const {
  Document restored = document;
  const double share =
      restore_better_parts(restored.mesh, end.doubt.sums, {given_.mesh, start.doubt.sums},
                           reach_px * photographs_.pixel());
  round_as_written(restored);
  if (share > 0 && clean_in_place(restored, progress).topology == result.topology) {
    SurfaceMeasures measures = photographs_.measures(restored.mesh, true, progress);
    if (!is_clearly_less(end.doubt.disagreement, measures.doubt.disagreement)) {
      document = std::move(restored);
      end = std::move(measures);
      result.restored = share;
    }
  }
  result.kept = reason_to_keep(start, end);
  if (result.kept.empty()) return end;
  keep_start(document, result);
  return start;
}

// Makes the given mesh the result.
void ResultJudge::keep_start(Document& document, ReconstructionResult& result) const {
  document = given_;
  document.mesh.vertex_columns.erase(doubt_column);
  const Components parts = connected_components(document.mesh);
  result.topology = {parts.components.size(), parts.genus()};
  result.crumbs = result.handles = 0;
  result.restored = 1;
  if (options_.on_note) options_.on_note("the initial mesh is kept: " + result.kept);
}

}  // namespace transformesh

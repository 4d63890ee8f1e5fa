#include "reconstruction/scale_rule.h"

#include "support/number.h"

namespace transformesh {
namespace {

// Limits that decide when a scale is finished; see ScaleRule and SweepVerdict in the header.
// Smaller values of `share_at_rest` and `improvement` take more sweeps per scale.
constexpr double share_at_rest = 0.015;
constexpr double improvement = 0.99;
constexpr double least_coverage_kept = 0.9;
constexpr double least_pixels_kept = 0.5;
/// If a smaller fraction of the vertices is outside of silhouettes, no vertices count as entering
/// silhouettes.
constexpr double outside_share = 0.002;
/// Vertices are entering silhouettes if the number of vertices outside fell below this fraction of
/// the number after the last sweep.
constexpr double entering_share = 0.9;
/// Changes of the topology at scales below this are faults. Slightly below 2, because scales are
/// rounded.
constexpr double late_scale = 1.99;

}  // namespace

bool is_late_scale(double scale) { return scale < late_scale; }

SweepVerdict ScaleRule::add(const Sweep& sweep, bool is_last) {
  const PhotoStepResult& last = sweep.steps.last;
  const bool is_first = done_ == 0;
  if (is_first) {
    coverage_ = sweep.steps.first.coverage;
    pixels_ = sweep.steps.first.pixels;
  }
  SweepVerdict verdict;
  verdict.is_lost = last.coverage < least_coverage_kept * coverage_ ||
                    real_count(last.pixels) < least_pixels_kept * real_count(pixels_);
  const bool is_slow = last.mean_share < share_at_rest ||
                       (!is_first && last.dissimilarity > improvement * before_.dissimilarity);
  const bool enters =
      real_count(last.outside) > outside_share * real_count(sweep.mesh.vertices) &&
      (is_first || real_count(last.outside) < entering_share * real_count(before_.outside));
  const bool is_other = !is_first && sweep.mesh.topology != before_.topology;
  const bool changes = enters || is_other;
  verdict.is_at_rest = !verdict.is_lost && is_slow && !changes;
  verdict.is_late = is_other && is_late_scale(sweep.scale_step.scale);
  ++done_;
  const bool needs_more = changes || (is_last && !verdict.is_lost);
  verdict.is_done = verdict.is_at_rest || done_ >= (needs_more ? 2 * sweeps_ : sweeps_);

  coverage_ = read_back(significant(coverage_, 6));
  before_ = {read_back(significant(last.dissimilarity, 6)), last.outside, sweep.mesh.topology};
  return verdict;
}

void ScaleRule::remember(LoopState& loop_state) {
  loop_state("pass", done_)("dissimilarity", before_.dissimilarity)("outside", before_.outside);
  loop_state("components", before_.topology.components)("genus", before_.topology.genus);
  loop_state("coverage", coverage_)("pixels", pixels_);
}

}  // namespace transformesh

#include "evolution/loop/stop_rules.h"

namespace transformesh {
namespace {

/// A value counts as improved if it is below this fraction of the best value so far. Closer to 1,
/// noise of remeshing counts as progress. Much smaller values end slow evolutions too early.
constexpr double improvement = 0.99;

/// Number of iterations without improvement after which a morph stalls. With fewer, slow morphs may
/// end too early. With more, every stalled morph makes more useless iterations.
constexpr std::size_t patience = 20;

/// Number of iterations without improvement after which a morph stalls if no vertex moves any more.
/// Smaller than `patience`, because further iterations change little.
constexpr std::size_t patience_at_rest = 3;

/// Number of iterations without improvement after which a coarse scale (long edges) ends. Smaller
/// than `patience`, because stalling at a coarse scale only means that shorter edges are needed.
constexpr std::size_t coarse_patience = 5;

/// Least number of iterations from one comparison with the target to the next. A comparison takes
/// longer than an iteration.
constexpr std::size_t iterations_between_looks = 5;

/// A vertex counts as at rest if it moves by less than this fraction of its clamp, the limit of its
/// movement in one step.
constexpr double rest_share = 0.02;

bool is_near(const MorphStepResult& step) {
  const double edge = step.displaced.mean_edge;
  return step.to_target.rms < edge / 2 && step.from_target.rms < edge / 2 &&
         step.from_target.maximum < 2 * edge;
}

}  // namespace

bool Best::takes(double next) {
  const bool is_better = value < 0 || next < improvement * value;
  if (is_better) value = next;
  return is_better;
}

bool StalledRule::add(double value) {
  idle_ = best_.takes(value) ? 0 : idle_ + 1;
  return idle_ >= patience_;
}

bool MorphRule::has_improved(const MorphStepResult& step) {
  bool result = rms_from_target_.takes(step.from_target.rms);
  result |= max_from_target_.takes(step.from_target.maximum);
  if (step.displaced.max_clamp_share <= 0.5) return result;
  result |= max_clamp_share_.takes(step.displaced.max_clamp_share);
  result |= rms_to_target_.takes(step.to_target.rms);
  result |= max_to_target_.takes(step.to_target.maximum);
  return result;
}

MorphVerdict MorphRule::verdict(const MorphStepResult& step, std::size_t vertices) const {
  // At the first step of a scale, the mesh still has the edge lengths of the previous scale.
  const bool has_settled = age_ > 1;
  if (scale_ > 0) {
    const bool has_room = has_settled && 100 * step.displaced.clamped <= vertices;
    return has_room || idle_ >= coarse_patience ? MorphVerdict::refine : MorphVerdict::go_on;
  }
  const double share = step.displaced.max_clamp_share;
  const bool may_look = unexamined_ >= iterations_between_looks;
  if (has_settled && share <= 0.5 && is_near(step) && may_look) return MorphVerdict::examine;
  if (idle_ < (share < rest_share ? patience_at_rest : patience)) return MorphVerdict::go_on;
  return is_near(step) ? MorphVerdict::examine_last : MorphVerdict::stalled;
}

MorphVerdict MorphRule::add(const MorphStepResult& step, std::size_t vertices) {
  idle_ = has_improved(step) ? 0 : idle_ + 1;
  ++age_;
  ++unexamined_;
  const MorphVerdict result = verdict(step, vertices);
  if (result == MorphVerdict::examine) unexamined_ = 0;
  if (result == MorphVerdict::refine) *this = MorphRule(scale_);
  return result;
}

void MorphRule::remember(LoopState& loop_state) {
  loop_state("scale", scale_)("idle", idle_)("age", age_)("unexamined", unexamined_);
  loop_state("rms_to_target", rms_to_target_.value)("max_to_target", max_to_target_.value);
  loop_state("rms_from_target", rms_from_target_.value)("max_from_target", max_from_target_.value);
  loop_state("max_clamp_share", max_clamp_share_.value);
}

}  // namespace transformesh

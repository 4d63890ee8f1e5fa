#include "tm/evolution/stop_rules.h"

namespace transformesh {
namespace {

constexpr double improvement = 0.99;
constexpr std::size_t patience = 20;
constexpr std::size_t patience_at_rest = 3;
constexpr std::size_t coarse_patience = 5;
constexpr double iterations_between_looks = 5;
/// Of its clamp, what a vertex moves that does not move any more.
constexpr double rest_share = 0.02;

bool is_near(const MorphMeasures& m) {
  return m.rms_to_target < m.mean_edge / 2 && m.rms_from_target < m.mean_edge / 2 &&
         m.max_from_target < 2 * m.mean_edge;
}

double taken(Values& values, const char* key, double otherwise) {
  const auto found = values.find(key);
  if (found == values.end()) return otherwise;
  const double value = found->second;
  values.erase(found);
  return value;
}

}  // namespace

bool StalledRule::add(double value) {
  const bool is_better = best_ < 0 || value < improvement * best_;
  if (is_better) best_ = value;
  idle_ = is_better ? 0 : idle_ + 1;
  return idle_ >= patience_;
}

void StalledRule::restore(const Values& values) {
  Values rest = values;
  best_ = taken(rest, "best", -1);
  idle_ = static_cast<std::size_t>(taken(rest, "idle", 0));
}

bool MorphRule::improves(const char* name, double value) {
  const auto [best, is_first] = best_.try_emplace(name, value);
  if (!is_first && !(value < improvement * best->second)) return false;
  best->second = value;
  return true;
}

bool MorphRule::has_improved(const MorphMeasures& m) {
  bool result = improves("rms_from_target", m.rms_from_target);
  result |= improves("max_from_target", m.max_from_target);
  if (m.max_clamp_share <= 0.5) return result;
  result |= improves("max_clamp_share", m.max_clamp_share);
  result |= improves("rms_to_target", m.rms_to_target);
  result |= improves("max_to_target", m.max_to_target);
  return result;
}

MorphVerdict MorphRule::verdict(const MorphMeasures& m) const {
  // The first step of a scale is made with the edges of the one before.
  const bool has_settled = age_ > 1;
  if (scale_ > 0) {
    const bool has_room = has_settled && 100 * m.clamped <= m.vertices;
    return has_room || idle_ >= coarse_patience ? MorphVerdict::refine : MorphVerdict::go_on;
  }
  const bool may_look = static_cast<double>(m.iteration) >= examined_ + iterations_between_looks;
  if (has_settled && m.max_clamp_share <= 0.5 && is_near(m) && may_look)
    return MorphVerdict::examine;
  const bool is_at_rest = m.max_clamp_share < rest_share;
  if (idle_ < (is_at_rest ? patience_at_rest : patience)) return MorphVerdict::go_on;
  return is_near(m) ? MorphVerdict::examine_last : MorphVerdict::stalled;
}

MorphVerdict MorphRule::add(const MorphMeasures& measures) {
  idle_ = has_improved(measures) ? 0 : idle_ + 1;
  ++age_;
  const MorphVerdict result = verdict(measures);
  if (result == MorphVerdict::examine) examined_ = static_cast<double>(measures.iteration);
  if (result == MorphVerdict::refine) begin_finer_scale();
  return result;
}

void MorphRule::begin_finer_scale() {
  --scale_;
  idle_ = age_ = 0;
  best_.clear();
}

Values MorphRule::values() const {
  Values values = best_;
  values["scale"] = scale_;
  values["idle"] = static_cast<double>(idle_);
  values["age"] = static_cast<double>(age_);
  values["examined"] = examined_;
  return values;
}

void MorphRule::restore(const Values& values) {
  best_ = values;
  scale_ = static_cast<int>(taken(best_, "scale", 0));
  idle_ = static_cast<std::size_t>(taken(best_, "idle", 0));
  age_ = static_cast<std::size_t>(taken(best_, "age", 0));
  examined_ = taken(best_, "examined", -9);
}

}  // namespace transformesh

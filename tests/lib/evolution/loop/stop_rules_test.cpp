#include "evolution/loop/stop_rules.h"

#include <doctest/doctest.h>

using namespace transformesh;

namespace {

constexpr std::size_t vertices = 1000;

MorphStepResult step_of(double rms, double maximum, double max_clamp_share, std::size_t clamped) {
  MorphStepResult step;
  step.to_target = step.from_target = {rms, maximum};
  step.displaced.max_clamp_share = max_clamp_share;
  step.displaced.clamped = clamped;
  step.displaced.mean_edge = 1;
  return step;
}

/// A step of a mesh that is far from its target and moves as fast as the clamp allows.
const MorphStepResult far_away = step_of(10, 20, 1, 500);
const MorphStepResult near_target = step_of(0.1, 0.3, 0.4, 0);

/// Returns the number of iterations until the verdict is not go_on, at most 99.
std::size_t iterations_until_verdict(MorphRule& rule, const MorphStepResult& step,
                                     MorphVerdict& verdict) {
  for (std::size_t i = 1; i < 100; ++i) {
    verdict = rule.add(step, vertices);
    if (verdict != MorphVerdict::go_on) return i;
  }
  return 99;
}

template <typename Rule>
Rule restored(Rule& rule, Rule blank) {
  LoopState kept;
  rule.remember(kept);
  LoopState loop_state(kept.text());
  blank.remember(loop_state);
  return blank;
}

}  // namespace

TEST_CASE("a value that gets no better by a hundredth in twenty iterations has stalled") {
  StalledRule rule;
  double value = 1;
  for (int i = 0; i < 100; ++i) CHECK_FALSE(rule.add(value *= 0.98));
  // Each value is less than one percent below the best.
  for (int i = 1; i < 20; ++i) CHECK_FALSE(rule.add(value * 0.991));
  CHECK(rule.add(value * 0.991));
}

TEST_CASE("a restored stall rule continues unchanged") {
  StalledRule rule(4);
  rule.add(1);
  rule.add(1);
  rule.add(1);
  StalledRule next = restored(rule, StalledRule(4));
  CHECK_FALSE(next.add(1));
  CHECK(next.add(1));
}

TEST_CASE("a morph is examined when it is near and slow, not at once and every fifth iteration") {
  MorphRule rule;
  const auto add = [&] { return rule.add(near_target, vertices); };
  CHECK(add() == MorphVerdict::go_on);
  CHECK(add() == MorphVerdict::examine);
  for (int i = 3; i < 7; ++i) CHECK(add() == MorphVerdict::go_on);
  CHECK(add() == MorphVerdict::examine);
}

TEST_CASE("each of the limits of nearness keeps a morph from being examined") {
  const auto verdict = [](auto change) {
    MorphRule rule;
    MorphStepResult step = near_target;
    change(step);
    rule.add(step, vertices);
    return rule.add(step, vertices);
  };
  using Step = MorphStepResult;
  CHECK(verdict([](Step&) {}) == MorphVerdict::examine);
  CHECK(verdict([](Step& s) { s.displaced.max_clamp_share = 0.51; }) == MorphVerdict::go_on);
  CHECK(verdict([](Step& s) { s.to_target.rms = 0.5; }) == MorphVerdict::go_on);
  CHECK(verdict([](Step& s) { s.from_target.rms = 0.5; }) == MorphVerdict::go_on);
  CHECK(verdict([](Step& s) { s.from_target.maximum = 2; }) == MorphVerdict::go_on);
  CHECK(verdict([](Step& s) { s.to_target.maximum = 2; }) == MorphVerdict::examine);
}

TEST_CASE("a morph that gets no better stalls in twenty iterations after the first") {
  MorphRule rule;
  MorphVerdict verdict{};
  CHECK(iterations_until_verdict(rule, far_away, verdict) == 21);
  CHECK(verdict == MorphVerdict::stalled);
}

TEST_CASE("if no vertex moves, a morph stalls before twenty iterations") {
  MorphRule rule;
  MorphVerdict verdict{};
  CHECK(iterations_until_verdict(rule, step_of(10, 20, 0.01, 500), verdict) == 4);
  CHECK(verdict == MorphVerdict::stalled);
}

TEST_CASE("a morph that oscillates near the target is compared for the last time") {
  MorphRule rule;
  MorphVerdict verdict{};
  CHECK(iterations_until_verdict(rule, step_of(0.1, 0.3, 0.9, 0), verdict) == 21);
  CHECK(verdict == MorphVerdict::examine_last);
}

TEST_CASE("a slow morph is judged only by distances from the target") {
  MorphRule rule;
  MorphStepResult step = step_of(10, 20, 0.4, 500);
  MorphVerdict verdict = MorphVerdict::go_on;
  std::size_t i = 0;
  // Distances to the target decrease, distances from the target do not.
  for (; verdict == MorphVerdict::go_on && i < 99; ++i) {
    step.to_target.rms *= 0.9;
    verdict = rule.add(step, vertices);
  }
  CHECK(i == 21);
}

TEST_CASE(
    "a coarse scale is refined when a hundredth of its vertices is clamped, or in five idle "
    "iterations") {
  MorphRule settled(3);
  const auto add = [&] { return settled.add(step_of(10, 20, 1, 10), vertices); };
  CHECK(add() == MorphVerdict::go_on);
  CHECK(settled.scale() == 2);
  CHECK(add() == MorphVerdict::refine);
  CHECK(settled.scale() == 1);
  // A finer scale restarts the count.
  CHECK(add() == MorphVerdict::go_on);
  CHECK(add() == MorphVerdict::refine);
  CHECK(settled.scale() == 0);
  CHECK(add() == MorphVerdict::go_on);
  CHECK(add() == MorphVerdict::go_on);

  MorphRule idle(2);
  MorphVerdict verdict{};
  CHECK(iterations_until_verdict(idle, step_of(10, 20, 1, 11), verdict) == 6);
  CHECK(verdict == MorphVerdict::refine);
}

TEST_CASE("a restored morph rule continues unchanged") {
  MorphRule whole(2);
  MorphRule parts(2);
  for (std::size_t i = 1; i < 60; ++i) {
    MorphStepResult step = i < 45 ? far_away : near_target;
    step.from_target.rms /= static_cast<double>(i < 40 ? i : 40);
    parts = restored(parts, MorphRule());
    CHECK(whole.add(step, vertices) == parts.add(step, vertices));
    CHECK(whole.scale() == parts.scale());
  }
}

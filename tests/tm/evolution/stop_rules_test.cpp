#include "tm/evolution/stop_rules.h"

#include <doctest/doctest.h>

using namespace transformesh;

namespace {

/// A mesh that is far from its target and moves as fast as it may.
MorphMeasures far_away(std::size_t iteration) {
  return {iteration, 1000, 500, 1.0, 10, 20, 10, 20, 1};
}

MorphMeasures near_target(std::size_t iteration) {
  return {iteration, 1000, 0, 0.4, 0.1, 0.3, 0.1, 0.3, 1};
}

/// Iterations until something else than going on comes out, at most 99.
std::size_t iterations_until_verdict(MorphRule& rule, MorphMeasures measures,
                                     MorphVerdict& verdict) {
  for (std::size_t i = 1; i < 100; ++i) {
    measures.iteration = i;
    verdict = rule.add(measures);
    if (verdict != MorphVerdict::go_on) return i;
  }
  return 99;
}

}  // namespace

TEST_CASE("a value that gets no better by a hundredth in twenty iterations has stalled") {
  StalledRule rule;
  double value = 1;
  for (int i = 0; i < 100; ++i) CHECK_FALSE(rule.add(value *= 0.98));
  // Less than a hundredth below the best, each time.
  for (int i = 1; i < 20; ++i) CHECK_FALSE(rule.add(value * 0.991));
  CHECK(rule.add(value * 0.991));
}

TEST_CASE("a stalled rule goes on from its values as if nothing had happened") {
  StalledRule rule(4);
  rule.add(1);
  rule.add(1);
  rule.add(1);
  StalledRule restored(4);
  restored.restore(values_of(text_of(rule.values())));
  CHECK_FALSE(restored.add(1));
  CHECK(restored.add(1));
}

TEST_CASE("a morph is examined when it is near and slow, not at once and every fifth iteration") {
  MorphRule rule;
  CHECK(rule.add(near_target(1)) == MorphVerdict::go_on);
  CHECK(rule.add(near_target(2)) == MorphVerdict::examine);
  for (std::size_t i = 3; i < 7; ++i) CHECK(rule.add(near_target(i)) == MorphVerdict::go_on);
  CHECK(rule.add(near_target(7)) == MorphVerdict::examine);
}

TEST_CASE("each of the limits of nearness keeps a morph from being examined") {
  const auto verdict = [](auto change) {
    MorphRule rule;
    MorphMeasures measures = near_target(1);
    change(measures);
    rule.add(measures);
    measures.iteration = 2;
    return rule.add(measures);
  };
  CHECK(verdict([](MorphMeasures&) {}) == MorphVerdict::examine);
  CHECK(verdict([](MorphMeasures& m) { m.max_clamp_share = 0.51; }) == MorphVerdict::go_on);
  CHECK(verdict([](MorphMeasures& m) { m.rms_to_target = 0.5; }) == MorphVerdict::go_on);
  CHECK(verdict([](MorphMeasures& m) { m.rms_from_target = 0.5; }) == MorphVerdict::go_on);
  CHECK(verdict([](MorphMeasures& m) { m.max_from_target = 2; }) == MorphVerdict::go_on);
  CHECK(verdict([](MorphMeasures& m) { m.max_to_target = 2; }) == MorphVerdict::examine);
}

TEST_CASE("a morph that gets no better stalls in twenty iterations after the first") {
  MorphRule rule;
  MorphVerdict verdict{};
  CHECK(iterations_until_verdict(rule, far_away(1), verdict) == 21);
  CHECK(verdict == MorphVerdict::stalled);
}

TEST_CASE("where no vertex moves any more nothing waits for twenty iterations") {
  MorphMeasures at_rest = far_away(1);
  at_rest.max_clamp_share = 0.01;
  MorphRule rule;
  MorphVerdict verdict{};
  CHECK(iterations_until_verdict(rule, at_rest, verdict) == 4);
  CHECK(verdict == MorphVerdict::stalled);
}

TEST_CASE("a vertex that is pulled to and fro near the target is looked at for the last time") {
  MorphMeasures restless = near_target(1);
  restless.max_clamp_share = 0.9;
  MorphRule rule;
  MorphVerdict verdict{};
  CHECK(iterations_until_verdict(rule, restless, verdict) == 21);
  CHECK(verdict == MorphVerdict::examine_last);
}

TEST_CASE("a slow morph is judged by what it misses alone") {
  MorphRule rule;
  MorphMeasures measures = far_away(1);
  measures.max_clamp_share = 0.4;
  MorphVerdict verdict = MorphVerdict::go_on;
  std::size_t i = 0;
  // Distances to the target fall, those from it do not.
  for (; verdict == MorphVerdict::go_on && i < 99; ++i) {
    measures.rms_to_target *= 0.9;
    verdict = rule.add(measures);
  }
  CHECK(i == 21);
}

TEST_CASE(
    "a coarse scale is refined when a hundredth of its vertices is clamped, or in five idle "
    "iterations") {
  MorphRule settled(3);
  MorphMeasures measures = far_away(1);
  measures.clamped = 10;
  CHECK(settled.add(measures) == MorphVerdict::go_on);
  CHECK(settled.scale() == 2);
  CHECK(settled.add(measures) == MorphVerdict::refine);
  CHECK(settled.scale() == 1);
  // A finer scale begins anew.
  CHECK(settled.add(measures) == MorphVerdict::go_on);
  CHECK(settled.add(measures) == MorphVerdict::refine);
  CHECK(settled.scale() == 0);
  CHECK(settled.add(measures) == MorphVerdict::go_on);
  CHECK(settled.add(measures) == MorphVerdict::go_on);

  MorphRule idle(2);
  measures.clamped = 11;
  MorphVerdict verdict{};
  CHECK(iterations_until_verdict(idle, measures, verdict) == 6);
  CHECK(verdict == MorphVerdict::refine);
}

TEST_CASE("the rule of a morph goes on from its values as if nothing had happened") {
  MorphRule whole(2);
  MorphRule parts(2);
  for (std::size_t i = 1; i < 60; ++i) {
    MorphMeasures measures = far_away(i);
    measures.rms_from_target = 10.0 / static_cast<double>(i < 40 ? i : 40);
    MorphRule next;
    next.restore(values_of(text_of(parts.values())));
    parts = next;
    CHECK(whole.add(measures) == parts.add(measures));
    CHECK(whole.scale() == parts.scale());
  }
}

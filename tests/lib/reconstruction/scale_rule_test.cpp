#include "reconstruction/scale_rule.h"

#include <doctest/doctest.h>

#include "helpers/moving_sweep.h"

using namespace transformesh;

namespace {

using test::moving;

Sweep with_topology(Sweep sweep, Topology topology) {
  sweep.mesh.topology = topology;
  return sweep;
}

Sweep with_outside(Sweep sweep, std::size_t outside) {
  sweep.steps.last.outside = outside;
  return sweep;
}

}  // namespace

TEST_CASE("a scale ends if vertices hardly move, or photographs hardly agree better") {
  ScaleRule rule;
  Sweep slow = moving(0.5);
  slow.steps.last.mean_share = 0.014;
  CHECK(rule.add(slow).is_done);
  rule.begin();
  CHECK_FALSE(rule.add(moving(0.5)).is_done);
  CHECK_FALSE(rule.add(moving(0.49)).is_done);
  const SweepVerdict verdict = rule.add(moving(0.486));
  CHECK(verdict.is_done);
  CHECK(verdict.is_at_rest);
}

TEST_CASE("a scale ends at its limit of sweeps, and does not count as at rest") {
  ScaleRule rule(2);
  CHECK_FALSE(rule.add(moving(0.5)).is_done);
  const SweepVerdict verdict = rule.add(moving(0.4));
  CHECK(verdict.is_done);
  CHECK_FALSE(verdict.is_at_rest);
}

TEST_CASE("the last scale has twice as many sweeps while the surface moves, unless it is lost") {
  for (const bool is_lost : {false, true}) {
    ScaleRule rule(2);
    rule.add(moving(0.5), true);
    Sweep second = moving(0.4);
    if (is_lost) second.steps.last.pixels = 449;
    CHECK(rule.add(second, true).is_done == is_lost);
  }
  ScaleRule rule(2);
  rule.add(moving(0.5), true);
  rule.add(moving(0.4), true);
  CHECK(rule.add(moving(0.3985), true).is_at_rest);
  rule.begin();
  for (const double dissimilarity : {0.5, 0.4, 0.3})
    CHECK_FALSE(rule.add(moving(dissimilarity), true).is_done);
  CHECK(rule.add(moving(0.2), true).is_done);
}

TEST_CASE("while the topology changes a scale has twice as many sweeps, and no rest") {
  ScaleRule rule(2);
  rule.add(moving(0.5));
  CHECK_FALSE(rule.add(with_topology(moving(0.5), {2, 0})).is_done);
  CHECK_FALSE(rule.add(with_topology(moving(0.5), {2, 1})).is_done);
  const SweepVerdict verdict = rule.add(with_topology(moving(0.5), {1, 1}));
  CHECK(verdict.is_done);
  CHECK_FALSE(verdict.is_at_rest);
}

TEST_CASE("while vertices move in from outside of silhouettes a scale continues") {
  ScaleRule rule(2);
  CHECK_FALSE(rule.add(with_outside(moving(0.5), 100)).is_done);
  CHECK_FALSE(rule.add(with_outside(moving(0.5), 80)).is_done);
  // Vertices that stay outside do not count as moving in, and a few vertices do not matter.
  CHECK(rule.add(with_outside(moving(0.5), 79)).is_done);
  rule.begin();
  rule.add(moving(0.5));
  CHECK(rule.add(with_outside(moving(0.5), 2)).is_at_rest);
}

TEST_CASE("a surface whose coverage decreases in a scale is lost, not at rest") {
  for (const bool is_share : {true, false}) {
    ScaleRule rule;
    CHECK_FALSE(rule.add(moving(0.5)).is_lost);
    Sweep lost = moving(0.5);
    if (is_share) lost.steps.last.coverage = 0.71;
    if (!is_share) lost.steps.last.pixels = 449;
    const SweepVerdict verdict = rule.add(lost);
    CHECK(verdict.is_lost);
    CHECK_FALSE(verdict.is_at_rest);
    CHECK_FALSE(verdict.is_done);
  }
  // Values are compared with the values at the beginning of the scale, not of the sweep.
  ScaleRule rule;
  rule.add(moving(0.5));
  Sweep later = moving(0.4);
  later.steps.first.coverage = 0.6;
  later.steps.last.coverage = 0.6;
  CHECK(rule.add(later).is_lost);
}

TEST_CASE("a topology that changes within a late scale is told from one that changes before") {
  const auto is_late = [](double scale, Topology before) {
    ScaleRule rule;
    rule.add(with_topology(moving(0.5), before));
    Sweep measures = with_topology(moving(0.3), {1, 5});
    measures.scale_step.scale = scale;
    return rule.add(measures).is_late;
  };
  CHECK(is_late(1.4142, {1, 6}));
  CHECK(is_late(1, {2, 5}));
  CHECK_FALSE(is_late(1.4142, {1, 5}));
  CHECK_FALSE(is_late(2, {1, 6}));
  // The topology may change between scales.
  ScaleRule rule;
  Sweep first = with_topology(moving(0.3), {1, 5});
  first.scale_step.scale = 1;
  CHECK_FALSE(rule.add(first).is_late);
}

TEST_CASE("a restored scale rule continues unchanged") {
  ScaleRule whole(6), parts(6);
  for (int i = 0; i < 6; ++i) {
    Sweep measures = with_outside(moving(0.123456789 / (1 + i)), 100 - 5 * (i / 2));
    measures.steps.last.coverage = 0.8123456789 - 0.03 * i;
    measures.mesh.topology = {1, -i / 3};
    ScaleRule next(6);
    LoopState kept;
    parts.remember(kept);
    LoopState loop_state(kept.text());
    next.remember(loop_state);
    parts = next;
    const SweepVerdict expected = whole.add(measures);
    const SweepVerdict found = parts.add(measures);
    CHECK(expected.is_done == found.is_done);
    CHECK(expected.is_lost == found.is_lost);
    CHECK(expected.is_at_rest == found.is_at_rest);
    CHECK(expected.is_late == found.is_late);
  }
}

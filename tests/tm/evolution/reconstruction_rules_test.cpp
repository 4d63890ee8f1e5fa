#include "tm/evolution/reconstruction_rules.h"

#include <doctest/doctest.h>

using namespace transformesh;

namespace {

/// A surface that moves, agrees better and better, and loses nothing.
Pass moving(double dissimilarity) {
  Pass pass;
  pass.level.scale = 4;
  pass.mesh.vertices = 1000;
  pass.mesh.topology = {1, 0};
  pass.steps.last.mean_share = 0.1;
  pass.steps.last.dissimilarity = dissimilarity;
  pass.steps.last.coverage = pass.steps.first.coverage = 0.8;
  pass.steps.last.pixels = pass.steps.first.pixels = 900;
  return pass;
}

Pass with_topology(Pass pass, Topology topology) {
  pass.mesh.topology = topology;
  return pass;
}

Pass with_outside(Pass pass, std::size_t outside) {
  pass.steps.last.outside = outside;
  return pass;
}

}  // namespace

TEST_CASE("a level is done where vertices hardly move, or photographs agree hardly better") {
  LevelRule rule;
  Pass slow = moving(0.5);
  slow.steps.last.mean_share = 0.014;
  CHECK(rule.add(slow).is_done);
  rule.begin();
  CHECK_FALSE(rule.add(moving(0.5)).is_done);
  CHECK_FALSE(rule.add(moving(0.49)).is_done);
  const PassVerdict verdict = rule.add(moving(0.486));
  CHECK(verdict.is_done);
  CHECK(verdict.is_at_rest);
}

TEST_CASE("a level ends after so many passes, and does not count as at rest") {
  LevelRule rule(2);
  CHECK_FALSE(rule.add(moving(0.5)).is_done);
  const PassVerdict verdict = rule.add(moving(0.4));
  CHECK(verdict.is_done);
  CHECK_FALSE(verdict.is_at_rest);
}

TEST_CASE("while the topology changes a level has twice as many passes, and no rest") {
  LevelRule rule(2);
  rule.add(moving(0.5));
  CHECK_FALSE(rule.add(with_topology(moving(0.5), {2, 0})).is_done);
  CHECK_FALSE(rule.add(with_topology(moving(0.5), {2, 1})).is_done);
  const PassVerdict verdict = rule.add(with_topology(moving(0.5), {1, 1}));
  CHECK(verdict.is_done);
  CHECK_FALSE(verdict.is_at_rest);
}

TEST_CASE("views are wide where even the nearest ones are more than 40 degrees apart on average") {
  const std::vector<ViewPair> eight{{0, 1, 45}, {0, 2, 50}, {1, 0, 45}, {2, 0, 50}, {2, 1, 39}};
  const std::vector<ViewPair> dense{{0, 1, 45}, {0, 2, 20}, {1, 0, 45}, {2, 0, 20}, {2, 3, 50}};
  CHECK(is_wide(eight));
  CHECK_FALSE(is_wide(dense));
  CHECK_FALSE(is_wide(std::vector<ViewPair>{}));
}

TEST_CASE("while vertices come in from outside of silhouettes a level goes on") {
  LevelRule rule(2);
  CHECK_FALSE(rule.add(with_outside(moving(0.5), 100)).is_done);
  CHECK_FALSE(rule.add(with_outside(moving(0.5), 80)).is_done);
  // Those that stay outside do not come in; and a few are none.
  CHECK(rule.add(with_outside(moving(0.5), 79)).is_done);
  rule.begin();
  rule.add(moving(0.5));
  CHECK(rule.add(with_outside(moving(0.5), 2)).is_at_rest);
}

TEST_CASE("a surface of which less is compared than when the level began is lost, not at rest") {
  for (const bool is_share : {true, false}) {
    LevelRule rule;
    CHECK_FALSE(rule.add(moving(0.5)).is_lost);
    Pass lost = moving(0.5);
    if (is_share) lost.steps.last.coverage = 0.71;
    if (!is_share) lost.steps.last.pixels = 449;
    const PassVerdict verdict = rule.add(lost);
    CHECK(verdict.is_lost);
    CHECK_FALSE(verdict.is_at_rest);
    CHECK_FALSE(verdict.is_done);
  }
  // What the level began with counts, not the pass.
  LevelRule rule;
  rule.add(moving(0.5));
  Pass later = moving(0.4);
  later.steps.first.coverage = 0.6;
  later.steps.last.coverage = 0.6;
  CHECK(rule.add(later).is_lost);
}

TEST_CASE("a topology that changes within a late scale is told from one that changes before") {
  const auto is_late = [](double scale, Topology before) {
    LevelRule rule;
    rule.add(with_topology(moving(0.5), before));
    Pass measures = with_topology(moving(0.3), {1, 5});
    measures.level.scale = scale;
    return rule.add(measures).is_late;
  };
  CHECK(is_late(1.4142, {1, 6}));
  CHECK(is_late(1, {2, 5}));
  CHECK_FALSE(is_late(1.4142, {1, 5}));
  CHECK_FALSE(is_late(2, {1, 6}));
  // From level to level it may change.
  LevelRule rule;
  Pass first = with_topology(moving(0.3), {1, 5});
  first.level.scale = 1;
  CHECK_FALSE(rule.add(first).is_late);
}

TEST_CASE("the rule of a level goes on from its memory as if nothing had happened") {
  LevelRule whole(6), parts(6);
  for (int i = 0; i < 6; ++i) {
    Pass measures = with_outside(moving(0.123456789 / (1 + i)), 100 - 5 * (i / 2));
    measures.steps.last.coverage = 0.8123456789 - 0.03 * i;
    measures.mesh.topology = {1, -i / 3};
    LevelRule next(6);
    Memory kept;
    parts.remember(kept);
    Memory memory(kept.text());
    next.remember(memory);
    parts = next;
    const PassVerdict expected = whole.add(measures);
    const PassVerdict found = parts.add(measures);
    CHECK(expected.is_done == found.is_done);
    CHECK(expected.is_lost == found.is_lost);
    CHECK(expected.is_at_rest == found.is_at_rest);
    CHECK(expected.is_late == found.is_late);
  }
}

TEST_CASE("a start is torn where a twentieth of what is compared is gone") {
  CHECK(is_torn(1000, 949));
  CHECK_FALSE(is_torn(1000, 950));
}

TEST_CASE(
    "a surface explodes where it goes to pieces, leaves the silhouettes or is hardly compared") {
  const auto explodes = [](const auto& change) {
    Pass pass = moving(0.5);
    change(pass);
    return is_exploded(pass, 2);
  };
  CHECK_FALSE(explodes([](Pass&) {}));
  CHECK(explodes([](Pass& pass) { pass.mesh.topology.components = 101; }));
  CHECK_FALSE(explodes([](Pass& pass) { pass.mesh.topology.components = 100; }));
  CHECK(explodes([](Pass& pass) { pass.steps.last.outside = 301; }));
  CHECK_FALSE(explodes([](Pass& pass) { pass.steps.last.outside = 300; }));
  // A start that was outside comes in; one that was hardly compared is no worse.
  CHECK_FALSE(
      explodes([](Pass& pass) { pass.steps.first.outside = pass.steps.last.outside = 600; }));
  CHECK(explodes([](Pass& pass) { pass.steps.last.coverage = 0.29; }));
  CHECK_FALSE(
      explodes([](Pass& pass) { pass.steps.first.coverage = pass.steps.last.coverage = 0.2; }));
  // Hundreds of objects are none that one went to pieces into.
  Pass many = moving(0.5);
  many.mesh.topology.components = 500;
  CHECK_FALSE(is_exploded(many, 50));
}

TEST_CASE("windows are those of coarse scales down to scale 2") {
  const WindowRadii radii{5, 2};
  CHECK(radii.at(11.3137) == 5);
  CHECK(radii.at(2) == 5);
  CHECK(radii.at(1.4142) == 2);
  CHECK(radii.at(1) == 2);
}

TEST_CASE("windows that disagree as much as the mean pull less where photographs agree well") {
  CHECK(robust_loss({}, 0.2) == 0.2);
  CHECK(robust_loss({}, 0.25) == 0);
  CHECK(robust_loss(0.5, 0.4) == 0.2);
  CHECK(robust_loss(0, 0.1) == 0);
  CHECK(robust_loss(1e-9, 0.1) == 0.001);
  CHECK(robust_loss(1e9, 0.1) == 1000);
}

TEST_CASE("what was lost comes before what moves, and that before what changed late") {
  const SurfaceEvidence good;
  CHECK(ReconstructionFaults{0, 0, true}.in_words(good).empty());
  CHECK(ReconstructionFaults{1.4142, 1, false}.in_words(good).find(
            "after scale 1.4142 than before") != std::string::npos);
  CHECK(ReconstructionFaults{0, 1, false}.in_words(good) ==
        "the surface was not at rest after the last pass");
  CHECK(ReconstructionFaults{0, 1, true}.in_words(good).find("as late as at scale 1.0000") !=
        std::string::npos);
}

TEST_CASE("a surface at rest is not converged where masks or photographs speak against it") {
  const ReconstructionFaults at_rest{0, 0, true};
  CHECK(at_rest.in_words({0.946, 0.942, {}}).empty());
  CHECK(at_rest.in_words({0.946, 0.902, {}}) ==
        "the outline agrees with the silhouettes by 0.902, that of the start by 0.946");
  SurfaceEvidence evidence;
  evidence.doubt.disagreement = 0.19;
  evidence.doubt.share = 0.029;
  evidence.doubt.places = {{{1, 2, 3}, 400, false}, {{4, 5, 60000}, 30, false}};
  CHECK(at_rest.in_words(evidence).empty());
  evidence.doubt.share = 0.031;
  CHECK(at_rest.in_words(evidence) ==
        "photographs disagree on 3.1 % of the surface, most around 1,2,3 (400 square pixels)");
  evidence.doubt.places[1].is_thin = true;
  CHECK(at_rest.in_words(evidence) ==
        "photographs disagree on a film or fin around 4,5,6e+04 (30 square pixels, thin)");
  evidence.doubt.disagreement = 0.21;
  CHECK(at_rest.in_words(evidence) == "photographs disagree by 0.21 beyond their noise");
}

TEST_CASE("a tracked surface is measured by the last one that was made anew") {
  const SurfaceQuality reference{0.2, 0.8, 0.95};
  CHECK(tracking_faults({0.259, 0.721, 0.921}, reference).empty());
  CHECK(tracking_faults({0.27, 0.8, 0.95}, reference) == "dissimilarity");
  CHECK(tracking_faults({0.2, 0.71, 0.91}, reference) == "coverage+silhouettes");
  // One that was lost altogether has all faults.
  CHECK(tracking_faults({}, reference) == "dissimilarity+coverage+silhouettes");
}

TEST_CASE("of two surfaces fewer faults count first, then the agreement of the photographs") {
  const SurfaceQuality reference{0.2, 0.8, 0.95};
  const SurfaceQuality crumpled{0.19, 0.5, 0.95};
  const SurfaceQuality good{0.25, 0.8, 0.95};
  CHECK(is_better(good, crumpled, reference));
  CHECK_FALSE(is_better(crumpled, good, reference));
  CHECK(is_better({0.3, 0.8, 0.95}, {0.31, 0.8, 0.95}, reference));
  CHECK_FALSE(is_better({0.31, 0.8, 0.95}, {0.31, 0.8, 0.95}, reference));
}

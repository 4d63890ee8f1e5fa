#include "evolution/topology_change.h"

#include <doctest/doctest.h>

using namespace transformesh;

namespace {

ComponentState state(std::set<long> labels, double volume, long genus = 0) {
  ComponentState result;
  result.label = *labels.begin();
  result.labels = std::move(labels);
  result.volume = volume;
  result.genus = genus;
  result.is_cavity = volume < 0;
  return result;
}

LabeledStates labeled(const std::vector<ComponentState>& states) {
  LabeledStates result;
  for (const ComponentState& one : states) result.emplace(one.label, one);
  return result;
}

/// Returns kinds and labels of the events, such as "merge 1 2 > 1; ".
std::string events_between(const LabeledStates& before, std::vector<ComponentState> after,
                           const std::vector<Seam>& seams = {}) {
  long next = 10;
  assign_labels(before, after, next);
  std::string text;
  for (const Event& event : find_events(before, after, seams)) {
    text += name_of(event.kind);
    for (const LabeledVolume& one : event.before) text += ' ' + std::to_string(one.label);
    text += " >";
    for (const LabeledVolume& one : event.after) text += ' ' + std::to_string(one.label);
    text += "; ";
  }
  return text;
}

Seam seam(double x, double size, std::set<long> labels, std::set<Index> components) {
  return {{Vec3(x, 0, 0), size}, std::move(labels), std::move(components)};
}

}  // namespace

TEST_CASE("the same components are no event") {
  const LabeledStates before = labeled({state({1}, 3), state({2}, 1, 4)});
  CHECK(is_same_topology(before, std::vector{state({1}, 2.5), state({2}, 7, 4)}));
  CHECK_FALSE(is_same_topology(before, std::vector{state({1, 2}, 4, 4)}));
  CHECK_FALSE(is_same_topology(before, std::vector{state({1}, 3), state({2}, 1, 3)}));
  CHECK_FALSE(is_same_topology(before, std::vector{state({1}, 3), state({1}, 1)}));
  CHECK(events_between(before, {state({1}, 2.5), state({2}, 7, 4)}).empty());
}

TEST_CASE(
    "the largest component keeps its label when some merge, and each of the others is a row") {
  const LabeledStates before = labeled({state({1}, 1), state({2}, 5), state({3}, 2)});
  CHECK(events_between(before, {state({1, 2, 3}, 8)}) == "merge 2 1 > 2; merge 2 3 > 2; ");
  // Volumes that differ only by rounding are equal, and the lower label stays.
  const LabeledStates equal = labeled({state({1}, 1), state({2}, 1 + 4e-15)});
  CHECK(events_between(equal, {state({1, 2}, 2)}) == "merge 1 2 > 1; ");
}

TEST_CASE("the largest part keeps the label when a component splits") {
  const LabeledStates before = labeled({state({4}, 6)});
  CHECK(events_between(before, {state({4}, 1), state({4}, 3), state({4}, 2)}) ==
        "split 4 > 4 11; split 4 > 4 10; ");
}

TEST_CASE("handles are counted over all components that take part") {
  const LabeledStates before = labeled({state({1}, 2, 1), state({2}, 1, 2)});
  CHECK(events_between(before, {state({1, 2}, 3, 3)}) == "merge 1 2 > 1; ");
  CHECK(events_between(before, {state({1, 2}, 3, 4)}) == "merge 1 2 > 1; handle opened 1 2 > 1; ");
  CHECK(events_between(before, {state({1}, 2, 0), state({2}, 1, 2)}) == "handle closed 1 > 1; ");
}

TEST_CASE("a cavity opens to the outside, and a hollow closes") {
  const LabeledStates shell = labeled({state({1}, 5), state({2}, -2)});
  CHECK(events_between(shell, {state({1, 2}, 3)}) == "cavity opened 1 2 > 1; ");
  const LabeledStates bowls = labeled({state({1}, 4), state({2}, 5)});
  CHECK(events_between(bowls, {state({1, 2}, 10), state({1, 2}, -1)}) ==
        "merge 2 1 > 2; cavity closed 2 > 2 10; ");
  const LabeledStates cavities = labeled({state({1}, 9), state({2}, -2), state({3}, -1)});
  CHECK(events_between(cavities, {state({1}, 9), state({2, 3}, -3)}) == "merge 2 3 > 2; ");
}

TEST_CASE("each event has a place of its own, the largest seams first") {
  const LabeledStates before = labeled({state({1}, 2), state({2}, 1)});
  std::vector<ComponentState> after{state({1, 2}, 3, 1)};
  const std::vector<Seam> seams{seam(7, 3, {1}, {0}), seam(1, 2, {1, 2}, {0}),
                                seam(5, 1, {1, 2}, {0})};
  const auto events = find_events(before, after, seams);
  REQUIRE(events.size() == 2);
  CHECK(events[0].place.x() == 1);
  CHECK(events[0].size == 2);
  CHECK(events[1].place.x() == 7);
}

TEST_CASE("the place of a split is between the nearest cuts of the parts") {
  const LabeledStates before = labeled({state({1}, 3)});
  std::vector<ComponentState> after{state({1}, 2), state({1}, 1)};
  after[1].label = 2;
  const std::vector<Seam> seams{seam(0, 5, {1}, {0}), seam(8, 3, {1}, {1}), seam(6, 1, {1}, {0})};
  const auto events = find_events(before, after, seams);
  REQUIRE(events.size() == 1);
  CHECK(events[0].place.x() == 7);
}

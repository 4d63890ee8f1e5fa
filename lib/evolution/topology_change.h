/// Finds the events (events.h) between the labeled components before a change of the surface and
/// the components after it, whose faces have the labels of those that they come from.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "evolution/component_states.h"
#include "evolution/seams.h"
#include "transformesh/events.h"

namespace transformesh {

using LabeledStates = std::map<long, ComponentState>;

/// True if each component after the change has one label, no two have the same one, and the genus
/// of each is that before.
bool is_same_topology(const LabeledStates& before, std::span<const ComponentState> after);

/// Labels the components: the largest takes the label, among those of its faces that no larger one
/// took, whose component was the largest. If none is left, it gets `next_label`, which increases.
/// Only labels of `before` count.
void assign_labels(const LabeledStates& before, std::span<ComponentState> after, long& next_label);

/// Returns the events without iteration and time, given labeled components and the seams, the
/// largest first. Components that vanished are not looked for.
std::vector<Event> find_events(const LabeledStates& before, std::span<const ComponentState> after,
                               std::span<const Seam> seams);

}  // namespace transformesh

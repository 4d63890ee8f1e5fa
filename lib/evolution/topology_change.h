/// Finds the events (events.h) of a change of the surface. Compares the labeled components before
/// the change with the components after it. Faces keep their labels from before the change.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "evolution/component_states.h"
#include "evolution/seams.h"
#include "transformesh/events.h"

namespace transformesh {

using LabeledStates = std::map<long, ComponentState>;

/// True if the faces of each component have a single label, no two components have the same label,
/// and each component has the genus that it had before.
bool is_same_topology(const LabeledStates& before, std::span<const ComponentState> after);

/// Labels the components, the largest first. A component takes a label of its faces that no other
/// component has taken. If there are several, it takes that of the largest component before the
/// change. A solid takes no label of a cavity, and a cavity takes no label of a solid. If no label
/// is left, the component gets `next_label`, which is incremented. Only labels in `before` count.
void assign_labels(const LabeledStates& before, std::span<ComponentState> after, long& next_label);

/// Returns the events, whose members `iteration` and `time` are not set. `after` must be labeled,
/// and `seams` must be sorted, the largest first. Components that vanished are not reported.
std::vector<Event> find_events(const LabeledStates& before, std::span<const ComponentState> after,
                               std::span<const Seam> seams);

}  // namespace transformesh

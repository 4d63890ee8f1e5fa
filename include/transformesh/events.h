/// Events of an evolution: the changes of topology in its steps. Each component has a label, a
/// number from 1 in the face column `component_label`, as long as the component exists. If
/// components merge, the largest one's label stays. If one splits, its largest part keeps the
/// label, and the others get new labels. A cavity is a component that encloses no solid (its volume
/// is negative).
///
/// An event is found from the labels of faces before and after cleaning, which carries labels, and
/// from the genus of components. Changes that cancel out within one step are not events.
#pragma once

#include <string>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

inline constexpr const char* component_label = "component_label";

enum class EventKind {
  merge,               ///< two components became one
  split,               ///< a part of a component separated from it
  handle_opened,       ///< the genus increased by one
  handle_closed,       ///< the genus decreased by one
  component_vanished,  ///< a component shrank to nothing, or to a size that remeshing removes
  cavity_opened,       ///< a cavity was connected to the outside
  cavity_closed        ///< a cavity was separated from the outside
};

/// Returns the name with spaces, as "handle opened".
std::string name_of(EventKind kind);

struct LabeledVolume {
  long label = 0;
  double volume = 0;  ///< cubic input units; negative for a cavity
};

struct Event {
  std::size_t iteration = 0;
  double time = 0;  ///< end of the step; number of the iteration in an evolution without time
  EventKind kind = EventKind::merge;
  Vec3 place = Vec3::Zero();
  /// Diameter of the neck. If surfaces were joined: twice the root mean square distance of their
  /// intersection curve from the curve's center. If a part separated: diameter of the largest ball
  /// around `place` that was free of the surface before the step. If a component vanished: twice
  /// the root mean square distance of its vertices from their center before the step.
  double size = 0;
  std::vector<LabeledVolume> before, after;  ///< components of the event before and after the step
};

}  // namespace transformesh

/// Labels of components, stored as the face column `component_label` (events.h), and the measures
/// of components that events report.
#pragma once

#include <set>
#include <span>
#include <vector>

#include "transformesh/components.h"

namespace transformesh {

/// Center of points, and twice their root mean square distance from it. If the points are evenly
/// spread on a circle or a sphere, these are its center and diameter.
struct Extent {
  Vec3 center = Vec3::Zero();
  double size = 0;
};
Extent extent_of(std::span<const Vec3> points);

struct ComponentState {
  /// Labels of the faces before the last change; faces that are new have none.
  std::set<long> labels;
  long label = 0;  ///< label of the component
  long genus = 0;
  double volume = 0;
  bool is_cavity = false;  ///< true if the component is closed and has negative volume
  Extent extent;
};

/// Returns the states of the components, in the order of `components`. The label of a component is
/// the least label of its faces, or 0 if no face has one.
std::vector<ComponentState> component_states(const Mesh& mesh, const Components& components);

/// Returns the label of each face from the column `component_label`. All labels are 0 if the mesh
/// has no such column.
std::vector<long> face_labels(const Mesh& mesh);

/// Stores a label for each face: the label in the state of its component.
void write_labels(Mesh& mesh, const Components& components, std::span<const ComponentState> states);

}  // namespace transformesh

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
  std::set<long> labels;  ///< labels of the faces before the last change; new faces have none
  long label = 0;         ///< label of the component
  long genus = 0;
  double volume = 0;
  bool is_cavity = false;  ///< closed, with negative volume
  Extent extent;
};

/// Returns the states in order of the components. `label` is the least label of the faces, or 0 if
/// no face has one.
std::vector<ComponentState> component_states(const Mesh& mesh, const Components& components);

/// Returns the label of each face; 0 for all if the mesh has no such column.
std::vector<long> face_labels(const Mesh& mesh);

/// Stores the label of its component for each face.
void write_labels(Mesh& mesh, const Components& components, std::span<const ComponentState> states);

}  // namespace transformesh

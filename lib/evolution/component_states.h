/// Labeled components of a mesh: the face column `component_label` (events.h), and the measures of
/// components that events report.
#pragma once

#include <set>
#include <span>
#include <vector>

#include "transformesh/components.h"

namespace transformesh {

/// Center of points, and twice their root mean square distance from it: the center and the diameter
/// of a circle or a sphere with evenly spread points.
struct Extent {
  Vec3 center = Vec3::Zero();
  double size = 0;
};
Extent extent_of(std::span<const Vec3> points);

struct ComponentState {
  std::set<long> labels;  ///< labels of its faces; new faces, as in caps, have none
  long label = 0;
  long genus = 0;
  double volume = 0;
  bool is_cavity = false;  ///< closed, with negative volume
  Extent extent;
};

/// Returns the states in order of the components. `label` is the least label of the faces, or 0.
std::vector<ComponentState> component_states(const Mesh& mesh, const Components& components);

/// Returns the label of each face; 0 for all if the mesh has no such column.
std::vector<long> face_labels(const Mesh& mesh);

/// Labels each face by its component's state.
void write_labels(Mesh& mesh, const Components& components, std::span<const ComponentState> states);

}  // namespace transformesh

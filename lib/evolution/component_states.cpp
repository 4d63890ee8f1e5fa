#include "evolution/component_states.h"

#include <cmath>
#include <utility>

#include "geometry/inward_components.h"
#include "transformesh/events.h"

namespace transformesh {

Extent extent_of(std::span<const Vec3> points) {
  Extent extent;
  if (points.empty()) return extent;
  const auto count = static_cast<double>(points.size());
  for (const Vec3& point : points) extent.center += point / count;
  double squares = 0;
  for (const Vec3& point : points) squares += (point - extent.center).squaredNorm();
  extent.size = 2 * std::sqrt(squares / count);
  return extent;
}

std::vector<ComponentState> component_states(const Mesh& mesh, const Components& components) {
  const std::vector<long> labels = face_labels(mesh);
  std::vector<ComponentState> states(components.components.size());
  std::vector<std::vector<Vec3>> points(states.size());
  std::vector<char> is_counted(mesh.positions.size(), 0);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Index component = components.of_face[f];
    if (labels[f] != 0) states[component].labels.insert(labels[f]);
    for (const Index v : mesh.faces[f])
      if (!std::exchange(is_counted[v], 1)) points[component].push_back(mesh.positions[v]);
  }
  const std::vector<char> is_inward = inward_components(mesh, components);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Component& component = components.components[i];
    if (!states[i].labels.empty()) states[i].label = *states[i].labels.begin();
    states[i].genus = component.genus();
    states[i].volume = component.volume;
    states[i].is_cavity = is_inward[i] != 0;
    states[i].extent = extent_of(points[i]);
  }
  return states;
}

std::vector<long> face_labels(const Mesh& mesh) {
  const Column* column = mesh.face_columns.find(component_label);
  if (column == nullptr) return std::vector<long>(mesh.faces.size(), 0);
  std::vector<long> labels;
  labels.reserve(column->values.size());
  for (const double value : column->values) labels.push_back(static_cast<long>(value));
  return labels;
}

void write_labels(Mesh& mesh, const Components& components,
                  std::span<const ComponentState> states) {
  Column& column = mesh.face_columns.get(component_label, Scalar::int32, mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    column.values[f] = static_cast<double>(states[components.of_face[f]].label);
}

}  // namespace transformesh

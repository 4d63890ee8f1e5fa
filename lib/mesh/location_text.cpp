#include "mesh/location_text.h"

#include "support/number.h"
#include "transformesh/length.h"

namespace transformesh {

std::string point_text(const Vec3& point) {
  std::string text = "(";
  text += shortest_text(point.x()) + ", ";
  text += shortest_text(point.y()) + ", ";
  return text + shortest_text(point.z()) + ")";
}

std::string rough_point_text(const Vec3& point) {
  constexpr int digits = 4;  // chosen by hand: enough to find the place in a viewer
  return '(' + significant(point.x(), digits) + ", " + significant(point.y(), digits) + ", " +
         significant(point.z(), digits) + ')';
}

std::string vertex_text(const Mesh& mesh, Index vertex) {
  return "vertex " + std::to_string(vertex) + " at " + point_text(mesh.positions[vertex]);
}

std::string edge_text(const Mesh& mesh, Index halfedge) {
  return "edge from " + vertex_text(mesh, halfedge_source(mesh, halfedge)) + " to " +
         vertex_text(mesh, halfedge_target(mesh, halfedge));
}

ErrorData edge_data(const Mesh& mesh, Index halfedge) {
  const Index source = halfedge_source(mesh, halfedge);
  return {.faces = {halfedge / 3},
          .edge = {{source, halfedge_target(mesh, halfedge)}},
          .position = position_data(mesh.positions[source])};
}

}  // namespace transformesh

#include "tm/mesh/place.h"

#include "tm/support/length.h"

namespace transformesh {

std::string vertex_text(const Mesh& mesh, Index vertex) {
  const Vec3& point = mesh.positions[vertex];
  return "vertex " + std::to_string(vertex) + " at (" + shortest_text(point.x()) + ", " +
         shortest_text(point.y()) + ", " + shortest_text(point.z()) + ")";
}

std::string edge_text(const Mesh& mesh, Index halfedge) {
  return "edge from " + vertex_text(mesh, halfedge_source(mesh, halfedge)) + " to " +
         vertex_text(mesh, halfedge_target(mesh, halfedge));
}

}  // namespace transformesh

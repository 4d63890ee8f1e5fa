#include "mesh/manifold.h"

#include <algorithm>

#include "mesh/edges.h"
#include "mesh/location_text.h"
#include "mesh/touching_borders.h"
#include "mesh/umbrellas.h"

namespace transformesh {
namespace {

/// Lists the edges that have one face, three or more, or two that have the same direction.
void check_edges(const Mesh& mesh, const Edges& edges, ManifoldReport& report) {
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    const auto halfedges = edges.halfedges(edge);
    if (halfedges.size() == 1) {
      report.border_halfedges.push_back(halfedges[0]);
    } else if (halfedges.size() > 2) {
      report.nonmanifold_edges.push_back(halfedges[0]);
    } else if (halfedge_source(mesh, halfedges[0]) == halfedge_source(mesh, halfedges[1])) {
      report.misoriented_edges.push_back(halfedges[0]);
    }
  }
  std::sort(report.border_halfedges.begin(), report.border_halfedges.end());
  std::sort(report.nonmanifold_edges.begin(), report.nonmanifold_edges.end());
  std::sort(report.misoriented_edges.begin(), report.misoriented_edges.end());
}

/// A vertex is bad with more than one umbrella, and at an edge of three or more faces.
void check_vertices(const Mesh& mesh, const Umbrellas& umbrellas, ManifoldReport& report) {
  std::vector<bool> is_bad(mesh.positions.size(), false);
  for (const Index halfedge : report.nonmanifold_edges) {
    is_bad[halfedge_source(mesh, halfedge)] = true;
    is_bad[halfedge_target(mesh, halfedge)] = true;
  }
  std::vector<Index> count(mesh.positions.size(), 0);
  for (const Index vertex : umbrellas.vertex_of) ++count[vertex];
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (count[v] == 0) report.isolated_vertices.push_back(static_cast<Index>(v));
    if (count[v] > 1 || is_bad[v]) report.nonmanifold_vertices.push_back(static_cast<Index>(v));
  }
}

void check_faces(const Mesh& mesh, ManifoldReport& report) {
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (is_collapsed(mesh.faces[f])) report.collapsed_faces.push_back(static_cast<Index>(f));
  }
}

std::string face_edge_text(const Mesh& mesh, Index halfedge) {
  return edge_text(mesh, halfedge) + " of face " + std::to_string(halfedge / 3);
}

std::string and_more(std::size_t count, const std::string& what) {
  return count < 2 ? "" : " (the first of " + std::to_string(count) + " such " + what + ")";
}

/// Names joining first: tm-fill would close borders that lie upon each other by flat patches.
std::string border_advice(const ManifoldReport& report) {
  if (report.touching_borders == 0) return "; tm-fill closes holes";
  return ", and " + std::to_string(report.touching_borders) +
         " border edges lie upon each other, as in a soup of triangles; tm-stitch joins them";
}

}  // namespace

ManifoldReport check_manifold(const Mesh& mesh) {
  ManifoldReport report;
  const Edges edges(mesh);
  check_edges(mesh, edges, report);
  const Umbrellas umbrellas = find_umbrellas(mesh, edges);
  check_vertices(mesh, umbrellas, report);
  check_faces(mesh, report);
  report.boundary_loops = boundary_loops(edges, umbrellas).size();
  report.touching_borders = count_touching_borders(mesh, report.border_halfedges);
  return report;
}

std::string describe_problem(const Mesh& mesh, const ManifoldReport& report, bool closed) {
  if (!report.collapsed_faces.empty())
    return "face " + std::to_string(report.collapsed_faces[0]) + " names a vertex twice" +
           and_more(report.collapsed_faces.size(), "faces");
  if (!report.nonmanifold_edges.empty())
    return "the " + face_edge_text(mesh, report.nonmanifold_edges[0]) + " has more than two faces" +
           and_more(report.nonmanifold_edges.size(), "edges");
  if (!report.nonmanifold_vertices.empty())
    return "the faces around " + vertex_text(mesh, report.nonmanifold_vertices[0]) +
           " do not form one umbrella" + and_more(report.nonmanifold_vertices.size(), "vertices");
  if (!report.misoriented_edges.empty())
    return "both faces of the " + face_edge_text(mesh, report.misoriented_edges[0]) +
           " run along it the same way" + and_more(report.misoriented_edges.size(), "edges");
  if (closed && !report.border_halfedges.empty())
    return "the " + face_edge_text(mesh, report.border_halfedges[0]) + " has no face across" +
           and_more(report.border_halfedges.size(), "edges") + border_advice(report);
  return "";
}

}  // namespace transformesh

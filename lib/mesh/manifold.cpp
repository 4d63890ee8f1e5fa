#include "transformesh/manifold.h"

#include <algorithm>
#include <utility>

#include "mesh/edges.h"
#include "mesh/location_text.h"
#include "mesh/touching_borders.h"
#include "mesh/umbrellas.h"

namespace transformesh {
namespace {

/// Lists the edges with one face, with three or more faces, or with two faces that traverse the
/// edge in the same direction.
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

/// A vertex is non-manifold if it has more than one umbrella, or an edge of three or more faces.
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

Problem edge_problem(ErrorKind kind, const std::string& what, const Mesh& mesh,
                     const std::vector<Index>& halfedges) {
  ErrorData data = edge_data(mesh, halfedges[0]);
  data.counts = {halfedges.size()};
  return {kind, what + and_more(halfedges.size(), "edges"), std::move(data)};
}

/// Reports coincident border edges together with the border. Such edges must be joined first:
/// filling the holes would put faces between them.
Problem border_problem(const Mesh& mesh, const ManifoldReport& report) {
  const std::vector<Index>& borders = report.border_halfedges;
  Problem problem =
      edge_problem(ErrorKind::not_closed,
                   "the " + face_edge_text(mesh, borders[0]) + " has only one face", mesh, borders);
  if (report.touching_borders == 0) return problem;
  problem.kind = ErrorKind::not_joined;
  problem.sentence += ", and " + std::to_string(report.touching_borders) +
                      " border edges coincide, as in a soup of triangles";
  problem.data.counts.push_back(report.touching_borders);
  return problem;
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

Problem manifold_problem(const Mesh& mesh, const ManifoldReport& report, bool closed) {
  if (!report.collapsed_faces.empty())
    return {ErrorKind::not_manifold,
            "face " + std::to_string(report.collapsed_faces[0]) + " uses a vertex twice" +
                and_more(report.collapsed_faces.size(), "faces"),
            {.faces = {report.collapsed_faces[0]}, .counts = {report.collapsed_faces.size()}}};
  if (!report.nonmanifold_edges.empty())
    return edge_problem(
        ErrorKind::not_manifold,
        "the " + face_edge_text(mesh, report.nonmanifold_edges[0]) + " has more than two faces",
        mesh, report.nonmanifold_edges);
  if (const std::vector<Index>& vertices = report.nonmanifold_vertices; !vertices.empty())
    return {ErrorKind::not_manifold,
            "the faces around " + vertex_text(mesh, vertices[0]) + " do not form one umbrella" +
                and_more(vertices.size(), "vertices"),
            {.position = position_data(mesh.positions[vertices[0]]), .counts = {vertices.size()}}};
  if (!report.misoriented_edges.empty())
    return edge_problem(ErrorKind::not_oriented,
                        "both faces of the " + face_edge_text(mesh, report.misoriented_edges[0]) +
                            " traverse it in the same direction",
                        mesh, report.misoriented_edges);
  if (closed && !report.border_halfedges.empty()) return border_problem(mesh, report);
  return {};
}

}  // namespace transformesh

#include "step/split_faces.h"

#include "mesh/edges.h"

namespace transformesh {
namespace {

/// Appends a midpoint for every edge longer than `longest`. Returns the midpoint of each halfedge,
/// or no_index.
std::vector<Index> add_midpoints(Mesh& mesh, double longest) {
  const Edges edges(mesh);
  std::vector<Index> midpoints(3 * mesh.faces.size(), no_index);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto halfedges = edges.halfedges(e);
    const Vec3 from = mesh.positions[halfedge_source(mesh, halfedges[0])];
    const Vec3 to = mesh.positions[halfedge_target(mesh, halfedges[0])];
    if (!((to - from).norm() > longest)) continue;
    for (const Index h : halfedges) midpoints[h] = static_cast<Index>(mesh.positions.size());
    mesh.positions.emplace_back(from + (to - from) / 2);
  }
  return midpoints;
}

/// Appends the triangles into which the midpoints of its edges divide a face. m[i] is the midpoint
/// of the edge from corner i to the next corner. It is no_index if this edge is not split.
void append_parts(const Face& face, const Face& m, std::vector<Face>& faces) {
  const auto count = std::count_if(m.begin(), m.end(), [](Index v) { return v != no_index; });
  if (count == 3) {
    faces.insert(
        faces.end(),
        {{face[0], m[0], m[2]}, {m[0], face[1], m[1]}, {m[2], m[1], face[2]}, {m[0], m[1], m[2]}});
    return;
  }
  // The face is rotated so that edge 0 has a midpoint. If two edges have midpoints, they are edges
  // 0 and 1.
  std::size_t i = 0;
  while (count > 0 && (m[i] == no_index || (count == 2 && m[(i + 1) % 3] == no_index))) ++i;
  const Index a = face[i], b = face[(i + 1) % 3], c = face[(i + 2) % 3];
  if (count == 0) faces.push_back(face);
  if (count == 1) faces.insert(faces.end(), {{a, m[i], c}, {m[i], b, c}});
  if (count == 2) {
    const Index n = m[(i + 1) % 3];
    faces.insert(faces.end(), {{a, m[i], c}, {m[i], b, n}, {m[i], n, c}});
  }
}

}  // namespace

bool split_faces(Mesh& mesh, double longest) {
  const std::size_t before = mesh.faces.size();
  for (std::size_t vertices = 0; vertices < mesh.positions.size();) {
    vertices = mesh.positions.size();
    const std::vector<Index> midpoints = add_midpoints(mesh, longest);
    std::vector<Face> faces;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
      append_parts(mesh.faces[f], {midpoints[3 * f], midpoints[3 * f + 1], midpoints[3 * f + 2]},
                   faces);
    mesh.faces = std::move(faces);
  }
  if (mesh.faces.size() == before) return false;
  mesh.vertex_columns = {};
  mesh.face_columns = {};
  return true;
}

}  // namespace transformesh

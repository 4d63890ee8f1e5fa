#include "tm/clean/stitch.h"

#include <algorithm>

#include "tm/clean/angular_order.h"
#include "tm/clean/orient.h"
#include "tm/clean/umbrellas.h"
#include "tm/clean/weld.h"

namespace transformesh {
namespace {

bool names_a_point_twice(const Face& f) { return f[0] == f[1] || f[1] == f[2] || f[2] == f[0]; }

// Replaces vertices by their welded representatives; drops faces that collapse.
std::size_t weld_faces(Mesh& mesh, const std::vector<Index>& representative) {
  std::vector<Face> faces;
  std::vector<Index> rows;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    Face face;
    for (std::size_t i = 0; i < 3; ++i) face[i] = representative[mesh.faces[f][i]];
    if (names_a_point_twice(face)) continue;
    faces.push_back(face);
    rows.push_back(f);
  }
  const std::size_t dropped = mesh.faces.size() - faces.size();
  if (dropped > 0) mesh.face_columns = mesh.face_columns.select(rows);
  mesh.faces = std::move(faces);
  return dropped;
}

void count_open_edges(const Edges& edges, const std::vector<Index>& opposite,
                      StitchResult& result) {
  for (std::size_t e = 0; e < edges.size(); ++e) {
    std::size_t open = 0;
    for (const Index h : edges.halfedges(e)) open += opposite[h] == no_index ? 1 : 0;
    if (open == edges.halfedges(e).size() && open == 2) {
      ++result.misoriented_edges;
    } else {
      result.border_edges += open;
    }
  }
}

// One vertex for each umbrella: the first at a position keeps the vertex, others get copies.
std::size_t number_umbrellas(Mesh& mesh, const Umbrellas& umbrellas) {
  std::vector<char> is_used(mesh.positions.size(), 0);
  std::vector<Index> vertex_of(umbrellas.point_of.size());
  std::vector<Index> copies;
  for (std::size_t u = 0; u < vertex_of.size(); ++u) {
    const Index point = umbrellas.point_of[u];
    vertex_of[u] = point;
    if (is_used[point]) {
      vertex_of[u] = static_cast<Index>(mesh.positions.size() + copies.size());
      copies.push_back(point);
    }
    is_used[point] = 1;
  }
  for (Index h = 0; h < umbrellas.of_corner.size(); ++h) {
    mesh.faces[h / 3][h % 3] = vertex_of[umbrellas.of_corner[h]];
  }

  // Vertices in use, in order, then the copies.
  std::vector<Index> rows;
  std::vector<Index> renumbered(mesh.positions.size() + copies.size(), no_index);
  for (Index v = 0; v < is_used.size(); ++v) {
    if (!is_used[v]) continue;
    renumbered[v] = static_cast<Index>(rows.size());
    rows.push_back(v);
  }
  for (std::size_t i = 0; i < copies.size(); ++i) {
    renumbered[mesh.positions.size() + i] = static_cast<Index>(rows.size());
    rows.push_back(copies[i]);
  }
  std::vector<Vec3> positions;
  for (const Index v : rows) positions.push_back(mesh.positions[v]);
  mesh.positions = std::move(positions);
  mesh.vertex_columns = mesh.vertex_columns.select(rows);
  for (Face& face : mesh.faces) {
    for (Index& v : face) v = renumbered[v];
  }
  return copies.size();
}

}  // namespace

StitchResult stitch(Mesh& mesh, const StitchOptions& options) {
  StitchResult result;
  const std::vector<Index> representative = weld(mesh.positions, options.tolerance);
  for (Index v = 0; v < representative.size(); ++v) {
    result.joined_vertices += representative[v] != v ? 1 : 0;
  }
  result.dropped_faces = weld_faces(mesh, representative);
  if (options.orient) result.turned_faces = orient_faces(mesh.faces, mesh.positions);

  const Edges edges(mesh);
  const auto sort = [&](std::span<const Index> halfedges) {
    return sort_around_edge(mesh, halfedges);
  };
  const std::vector<Index> opposite = pair_across_inside(mesh.faces, edges, sort);
  count_open_edges(edges, opposite, result);
  const std::vector<char> all(mesh.faces.size(), 1);
  result.copied_vertices = number_umbrellas(mesh, find_umbrellas(mesh.faces, all, opposite));
  if (options.flip) {
    for (Face& face : mesh.faces) std::swap(face[1], face[2]);
  }
  return result;
}

}  // namespace transformesh

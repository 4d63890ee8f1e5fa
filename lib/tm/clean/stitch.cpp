#include "tm/clean/stitch.h"

#include <algorithm>

#include "tm/clean/angular_order.h"
#include "tm/clean/orient.h"
#include "tm/clean/orientation_check.h"
#include "tm/clean/split_singular_edges.h"
#include "tm/clean/umbrellas.h"
#include "tm/clean/weld.h"

namespace transformesh {
namespace {

// Replaces vertices by those that they are joined with.
std::size_t join_vertices(Mesh& mesh, double tolerance) {
  const std::vector<Index> representative = weld(mesh.positions, tolerance);
  for (Face& face : mesh.faces) {
    for (Index& v : face) v = representative[v];
  }
  std::size_t joined = 0;
  for (Index v = 0; v < representative.size(); ++v) joined += representative[v] != v ? 1 : 0;
  return joined;
}

std::size_t drop_collapsed_faces(Mesh& mesh) {
  std::vector<Face> faces;
  std::vector<Index> rows;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    if (is_collapsed(mesh.faces[f])) continue;
    faces.push_back(mesh.faces[f]);
    rows.push_back(f);
  }
  const std::size_t dropped = mesh.faces.size() - faces.size();
  if (dropped > 0) mesh.face_columns = mesh.face_columns.select(rows);
  mesh.faces = std::move(faces);
  return dropped;
}

// Those that stay open along one edge all run the same way.
void count_open_edges(const Edges& edges, const std::vector<Index>& opposite,
                      StitchResult& result) {
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto halfedges = edges.halfedges(e);
    const auto open = std::count_if(halfedges.begin(), halfedges.end(),
                                    [&](Index h) { return opposite[h] == no_index; });
    if (open == 1) ++result.border_edges;
    if (open > 1) ++result.misoriented_edges;
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

std::size_t split_edges(Mesh& mesh, std::vector<Index>& opposite) {
  const EdgeSplits splits = split_singular_edges(mesh, opposite);
  for (const auto& [face, ends] : splits.vertices) {
    mesh.vertex_columns.append({{ends[0], ends[1], ends[1]}, {0.5, 0.5, 0}});
  }
  for (const Index face : splits.face_source) {
    mesh.face_columns.append({{face, face, face}, {1, 0, 0}});
  }
  return splits.edges;
}

}  // namespace

StitchResult stitch(Mesh& mesh, const StitchOptions& options) {
  StitchResult result;
  result.joined_vertices = join_vertices(mesh, options.tolerance);
  if (options.orient) result.turned_faces = orient_faces(mesh);
  const std::vector<Face> all_faces = mesh.faces;
  result.dropped_faces = drop_collapsed_faces(mesh);

  const Edges edges(mesh);
  std::vector<Index> opposite = pair_across_inside(
      mesh.faces, edges,
      [&](std::span<const Index> halfedges) { return sort_around_edge(mesh, halfedges); });
  count_open_edges(edges, opposite, result);
  if (result.misoriented_edges > 0) {
    result.misorientation = describe_misorientation({mesh.positions, all_faces, {}, {}});
  }
  const std::vector<char> all(mesh.faces.size(), 1);
  result.copied_vertices = number_umbrellas(mesh, find_umbrellas(mesh.faces, all, opposite));
  result.split_edges = split_edges(mesh, opposite);
  if (options.flip) {
    for (Face& face : mesh.faces) std::swap(face[1], face[2]);
  }
  return result;
}

}  // namespace transformesh

#include "views/depth/trim_border.h"

#include <algorithm>

#include "mesh/edges.h"
#include "mesh/umbrellas.h"
#include "transformesh/components.h"

namespace transformesh {
namespace {

/// Returns the marks, extended by one ring: all vertices of faces that have a marked vertex are
/// marked.
std::vector<char> grown(const Mesh& mesh, const std::vector<char>& is_marked) {
  std::vector<char> result = is_marked;
  for (const Face& face : mesh.faces)
    if (is_marked[face[0]] || is_marked[face[1]] || is_marked[face[2]])
      for (const Index vertex : face) result[vertex] = 1;
  return result;
}

std::vector<char> grown(const Mesh& mesh, std::vector<char> is_marked, int rings) {
  for (int ring = 0; ring < rings; ++ring) is_marked = grown(mesh, is_marked);
  return is_marked;
}

std::vector<char> border_vertices(const Mesh& mesh) {
  std::vector<char> is_border(mesh.positions.size(), 0);
  const Edges edges(mesh);
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    if (edges.halfedges(edge).size() != 1) continue;
    const Index halfedge = edges.halfedges(edge)[0];
    const Face& face = mesh.faces[halfedge / 3];
    is_border[face[halfedge % 3]] = is_border[face[(halfedge + 1) % 3]] = 1;
  }
  return is_border;
}

void drop_fringes(Mesh& mesh, int rings) {
  std::vector<char> is_core = grown(mesh, border_vertices(mesh), rings);
  for (char& mark : is_core) mark = mark == 0 ? 1 : 0;
  const std::vector<char> is_kept = grown(mesh, std::move(is_core), rings + 1);
  std::vector<bool> keeps;
  for (const auto& [a, b, c] : mesh.faces)
    keeps.push_back(is_kept[a] != 0 && is_kept[b] != 0 && is_kept[c] != 0);
  mesh = select_faces(mesh, keeps);
}

/// Returns true for faces that belong to the largest umbrella of each of their three vertices. An
/// umbrella is a set of faces at a vertex that are connected across edges.
std::vector<bool> in_largest_umbrellas(const Mesh& mesh) {
  const Umbrellas umbrellas = find_umbrellas(mesh, Edges(mesh));
  std::vector<Index> sizes(umbrellas.vertex_of.size(), 0);
  for (const Index umbrella : umbrellas.of_corner) ++sizes[umbrella];
  std::vector<Index> largest(mesh.positions.size(), no_index);
  for (Index u = 0; u < sizes.size(); ++u) {
    Index& best = largest[umbrellas.vertex_of[u]];
    if (best == no_index || sizes[u] > sizes[best]) best = u;
  }
  std::vector<bool> result(mesh.faces.size(), true);
  for (std::size_t corner = 0; corner < umbrellas.of_corner.size(); ++corner) {
    const Index umbrella = umbrellas.of_corner[corner];
    if (largest[umbrellas.vertex_of[umbrella]] != umbrella) result[corner / 3] = false;
  }
  return result;
}

}  // namespace

void trim_border(Mesh& mesh, int rings) {
  drop_fringes(mesh, rings);
  // Repeat until no face is dropped. Dropping a face can disconnect the faces around its other
  // vertices.
  for (;;) {
    const std::vector<bool> keeps = in_largest_umbrellas(mesh);
    if (std::find(keeps.begin(), keeps.end(), false) == keeps.end()) return;
    mesh = select_faces(mesh, keeps);
  }
}

}  // namespace transformesh

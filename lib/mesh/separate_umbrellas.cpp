#include "mesh/separate_umbrellas.h"

namespace transformesh {
namespace {

// Appends duplicates of vertices, and removes vertices that no face uses, except those whose flag
// in `stays` is set. `copies` has the original vertex of each duplicate; the faces already refer to
// the duplicates by indices after those of the mesh's vertices. The order of vertices does not
// change.
void drop_unused_vertices(Mesh& mesh, const std::vector<Index>& copies,
                          const std::vector<char>& stays) {
  std::vector<Index> renumbered(mesh.positions.size() + copies.size(), no_index);
  for (const Face& face : mesh.faces) {
    for (const Index v : face) renumbered[v] = 0;
  }
  for (Index v = 0; v < stays.size(); ++v) {
    if (stays[v] != 0) renumbered[v] = 0;
  }
  std::vector<Index> rows;
  std::vector<Vec3> positions;
  for (Index v = 0; v < renumbered.size(); ++v) {
    if (renumbered[v] == no_index) continue;
    renumbered[v] = static_cast<Index>(rows.size());
    rows.push_back(v < mesh.positions.size() ? v : copies[v - mesh.positions.size()]);
    positions.push_back(mesh.positions[rows.back()]);
  }
  mesh.positions = std::move(positions);
  mesh.vertex_columns = mesh.vertex_columns.select(rows);
  for (Face& face : mesh.faces) {
    for (Index& v : face) v = renumbered[v];
  }
}

}  // namespace

std::size_t separate_umbrellas(Mesh& mesh, const Umbrellas& umbrellas,
                               const std::vector<char>& stays) {
  std::vector<char> is_taken(mesh.positions.size(), 0);
  RawVector<Index> vertex_of = umbrellas.vertex_of;
  std::vector<Index> copies;
  for (Index& v : vertex_of) {
    if (!is_taken[v]) {
      is_taken[v] = 1;
      continue;
    }
    copies.push_back(v);
    v = static_cast<Index>(mesh.positions.size() + copies.size() - 1);
  }
  for (Index h = 0; h < umbrellas.of_corner.size(); ++h) {
    mesh.faces[h / 3][h % 3] = vertex_of[umbrellas.of_corner[h]];
  }
  drop_unused_vertices(mesh, copies, stays);
  return copies.size();
}

}  // namespace transformesh

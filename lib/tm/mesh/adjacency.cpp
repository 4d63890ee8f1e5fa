#include "tm/mesh/adjacency.h"

#include "tm/mesh/edges.h"

namespace transformesh {
namespace {

/// Calls visit(vertex) once for each vertex that the face names.
template <class Visit>
void for_each_distinct_corner(const Face& face, const Visit& visit) {
  visit(face[0]);
  if (face[1] != face[0]) visit(face[1]);
  if (face[2] != face[0] && face[2] != face[1]) visit(face[2]);
}

}  // namespace

std::vector<Index> opposite_halfedges(const Mesh& mesh) {
  std::vector<Index> opposite = neighbors_across(Edges(mesh), mesh.faces.size());
  for (Index h = 0; h < opposite.size(); ++h) {
    const Index other = opposite[h];
    if (other != no_index && halfedge_source(mesh, h) == halfedge_source(mesh, other))
      opposite[h] = opposite[other] = no_index;
  }
  return opposite;
}

VertexFaces::VertexFaces(const Mesh& mesh) : offsets_(mesh.positions.size() + 2, 0) {
  // A counting sort whose counts stand one slot ahead, so that filling leaves the offsets in place.
  for (const Face& face : mesh.faces)
    for_each_distinct_corner(face, [&](Index vertex) { ++offsets_[vertex + 2]; });
  for (std::size_t i = 1; i < offsets_.size(); ++i) offsets_[i] += offsets_[i - 1];
  faces_.resize(offsets_.back());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for_each_distinct_corner(mesh.faces[f], [&](Index vertex) {
      faces_[offsets_[vertex + 1]++] = static_cast<Index>(f);
    });
}

}  // namespace transformesh

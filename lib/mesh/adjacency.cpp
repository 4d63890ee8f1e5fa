#include "mesh/adjacency.h"

#include <algorithm>

namespace transformesh {
namespace {

/// Calls visit(vertex) once for each distinct vertex of the face.
template <class Visit>
void for_each_distinct_corner(const Face& face, const Visit& visit) {
  visit(face[0]);
  if (face[1] != face[0]) visit(face[1]);
  if (face[2] != face[0] && face[2] != face[1]) visit(face[2]);
}

/// True if the faces at each vertex form a single umbrella. Pre: every halfedge has an opposite.
bool has_single_umbrellas(const Mesh& mesh, std::span<const Index> opposites) {
  // 1 for each outgoing halfedge that was reached.
  std::vector<char> is_reached(opposites.size(), 0);
  std::vector<char> has_umbrella(mesh.positions.size(), 0);
  for (Index first = 0; first < opposites.size(); ++first) {
    if (is_reached[first]) continue;
    char& is_second = has_umbrella[halfedge_source(mesh, first)];
    if (is_second) return false;
    is_second = 1;
    for (Index h = first; !is_reached[h]; h = opposites[previous_halfedge(h)]) is_reached[h] = 1;
  }
  return true;
}

}  // namespace

std::optional<std::vector<Index>> closed_opposites(const Mesh& mesh, std::vector<Index> opposites) {
  const bool is_closed = std::find(opposites.begin(), opposites.end(), no_index) == opposites.end();
  if (!is_closed || !has_single_umbrellas(mesh, opposites)) return std::nullopt;
  return opposites;
}

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
  // A counting sort. Counts are shifted by one slot, so that the offsets are correct after filling.
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

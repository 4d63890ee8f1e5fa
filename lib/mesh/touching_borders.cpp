#include "mesh/touching_borders.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "mesh/edges.h"
#include "support/counted.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

/// Returns false only if the mesh has no border. If each edge has a face on both sides, outgoing
/// and incoming halfedges of a vertex lead to the same vertices, so the sums of indices are equal.
bool may_have_borders(const Mesh& mesh) {
  std::vector<Index> difference(mesh.positions.size(), 0);
  for (const Face& face : mesh.faces) {
    difference[face[0]] += face[1] - face[2];
    difference[face[1]] += face[2] - face[0];
    difference[face[2]] += face[0] - face[1];
  }
  return std::ranges::any_of(difference, [](Index sum) { return sum != 0; });
}

std::vector<Index> border_halfedges(const Mesh& mesh) {
  const Edges edges(mesh);
  std::vector<Index> borders;
  for (std::size_t edge = 0; edge < edges.size(); ++edge)
    if (edges.halfedges(edge).size() == 1) borders.push_back(edges.halfedges(edge)[0]);
  return borders;
}

/// Returns a number for each vertex of the halfedges, and no_index for all other vertices. Vertices
/// have equal numbers if their positions are equal.
std::vector<Index> numbered_places(const Mesh& mesh, const std::vector<Index>& halfedges) {
  std::vector<Index> places(mesh.positions.size(), no_index);
  std::vector<std::pair<Vec3, Index>> vertices;
  vertices.reserve(halfedges.size());
  for (const Index h : halfedges)
    for (const Index v : {halfedge_source(mesh, h), halfedge_target(mesh, h)})
      if (std::exchange(places[v], 0) == no_index) vertices.emplace_back(mesh.positions[v], v);
  std::ranges::sort(vertices, [](const auto& a, const auto& b) {
    return std::ranges::lexicographical_compare(a.first, b.first);
  });
  Index place = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (i > 0 && vertices[i].first != vertices[i - 1].first) ++place;
    places[vertices[i].second] = place;
  }
  return places;
}

/// An edge between two places, and whether its halfedge leads from the larger number to the
/// smaller.
using PlacedEdge = std::tuple<Index, Index, bool>;

std::vector<PlacedEdge> placed_edges(const Mesh& mesh, const std::vector<Index>& halfedges) {
  const std::vector<Index> places = numbered_places(mesh, halfedges);
  std::vector<PlacedEdge> edges;
  edges.reserve(halfedges.size());
  for (const Index h : halfedges) {
    const Index from = places[halfedge_source(mesh, h)], to = places[halfedge_target(mesh, h)];
    if (from != to) edges.emplace_back(std::min(from, to), std::max(from, to), from > to);
  }
  return edges;
}

}  // namespace

std::size_t count_touching_borders(const Mesh& mesh, const std::vector<Index>& borders) {
  std::vector<PlacedEdge> edges = placed_edges(mesh, borders);
  std::ranges::sort(edges);
  std::size_t count = 0;
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    const auto [a, b, is_first_reversed] = edges[begin];
    while (end < edges.size() && std::get<0>(edges[end]) == a && std::get<1>(edges[end]) == b)
      ++end;
    if (std::get<2>(edges[end - 1]) != is_first_reversed) count += end - begin;
  }
  return count;
}

std::size_t count_touching_borders(const Mesh& mesh) {
  return may_have_borders(mesh) ? count_touching_borders(mesh, border_halfedges(mesh)) : 0;
}

void refuse_touching_borders(const Mesh& mesh) {
  const std::size_t count = count_touching_borders(mesh);
  if (count == 0) return;
  throw InputError(ErrorKind::not_joined,
                   counted(count, "border edge") +
                       " coincide, as in a soup of triangles: the faces share no vertices there "
                       "and would come apart",
                   {.counts = {count}});
}

}  // namespace transformesh

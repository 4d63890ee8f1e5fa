#include "mesh/touching_borders.h"

#include <algorithm>
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

/// Returns the index of the position of each halfedge end, source and target in turn. Equal
/// positions have equal indices.
std::vector<Index> numbered_places(const Mesh& mesh, const std::vector<Index>& halfedges) {
  std::vector<std::pair<Vec3, std::size_t>> ends;
  for (const Index h : halfedges) {
    ends.emplace_back(mesh.positions[halfedge_source(mesh, h)], ends.size());
    ends.emplace_back(mesh.positions[halfedge_target(mesh, h)], ends.size());
  }
  std::ranges::sort(ends, [](const auto& a, const auto& b) {
    return std::ranges::lexicographical_compare(a.first, b.first);
  });
  std::vector<Index> places(ends.size());
  Index place = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (i > 0 && ends[i].first != ends[i - 1].first) ++place;
    places[ends[i].second] = place;
  }
  return places;
}

}  // namespace

std::size_t count_touching_borders(const Mesh& mesh, const std::vector<Index>& borders) {
  const std::vector<Index> places = numbered_places(mesh, borders);
  std::vector<std::pair<Index, Index>> edges;
  for (std::size_t i = 0; i < places.size(); i += 2)
    if (places[i] != places[i + 1]) edges.emplace_back(places[i], places[i + 1]);
  std::ranges::sort(edges);
  return static_cast<std::size_t>(std::ranges::count_if(edges, [&](const auto& edge) {
    return std::ranges::binary_search(edges, std::pair(edge.second, edge.first));
  }));
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

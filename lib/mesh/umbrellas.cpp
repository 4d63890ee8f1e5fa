#include "mesh/umbrellas.h"

#include <algorithm>

#include "mesh/connected_minima.h"
#include "mesh/disjoint_sets.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

/// Calls visit(neighbor) for the corners next to a corner at the same vertex, in the faces across
/// the two edges at this corner. The two halfedges of an edge usually have opposite directions: the
/// source of one is the target of the other. If both start at the same vertex, because their faces
/// have different orientations, the corners at their sources are neighbors.
template <bool is_oriented, class Visit>
void for_each_neighbor(std::span<const Face> faces, std::span<const Index> across, Index corner,
                       const Visit& visit) {
  const auto have_same_direction = [&](Index h, Index other) {
    return !is_oriented && faces[h / 3][h % 3] == faces[other / 3][other % 3];
  };
  const Index out = across[corner];
  if (out != no_index) visit(have_same_direction(corner, out) ? out : next_halfedge(out));
  const Index before = previous_halfedge(corner), in = across[before];
  if (in != no_index) visit(have_same_direction(before, in) ? next_halfedge(in) : in);
}

template <bool is_oriented>
Umbrellas find(std::span<const Face> faces, std::span<const Index> across,
               std::span<const char> included) {
  Umbrellas umbrellas;
  umbrellas.of_corner = connected_minima(across.size(), [&](Index corner, const auto& visit) {
    for_each_neighbor<is_oriented>(faces, across, corner, visit);
  });
  umbrellas.first_corner = number_components(umbrellas.of_corner, [&](Index corner) {
    return included.empty() || included[corner / 3] != 0;
  });
  umbrellas.vertex_of.resize(umbrellas.first_corner.size());
  parallel_for_each(umbrellas.vertex_of.size(), [&](Index u) {
    const Index corner = umbrellas.first_corner[u];
    umbrellas.vertex_of[u] = faces[corner / 3][corner % 3];
  });
  return umbrellas;
}

}  // namespace

Umbrellas find_umbrellas(std::span<const Face> faces, std::span<const Index> across,
                         std::span<const char> included) {
  return find<false>(faces, across, included);
}

Umbrellas find_oriented_umbrellas(std::span<const Face> faces, std::span<const Index> across,
                                  std::span<const char> included) {
  return find<true>(faces, across, included);
}

Umbrellas find_umbrellas(const Mesh& mesh, const Edges& edges) {
  return find_umbrellas(mesh.faces, neighbors_across(edges, mesh.faces.size()));
}

std::vector<Index> boundary_loops(const Edges& edges, const Umbrellas& umbrellas) {
  // Border edges that share an umbrella belong to one loop.
  std::vector<Index> border;
  DisjointSets loops(umbrellas.vertex_of.size());
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    if (edges.halfedges(edge).size() != 1) continue;
    const Index h = edges.halfedges(edge)[0];
    border.push_back(h);
    loops.join(umbrellas.of_corner[h], umbrellas.of_corner[next_halfedge(h)]);
  }

  std::sort(border.begin(), border.end());
  std::vector<Index> firsts;
  std::vector<bool> is_counted(umbrellas.vertex_of.size(), false);
  for (const Index halfedge : border) {
    const Index loop = loops.find(umbrellas.of_corner[halfedge]);
    if (!is_counted[loop]) firsts.push_back(halfedge);
    is_counted[loop] = true;
  }
  return firsts;
}

}  // namespace transformesh

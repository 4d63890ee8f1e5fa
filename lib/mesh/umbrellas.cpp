#include "mesh/umbrellas.h"

#include <algorithm>

#include "mesh/disjoint_sets.h"

namespace transformesh {

Umbrellas find_umbrellas(std::span<const Face> faces, std::span<const Index> across,
                         std::span<const char> included) {
  // If two halfedges of an edge start at the same vertex, their sources are joined, and so are
  // their targets. Otherwise each source is joined with the other's target.
  DisjointSets corners(3 * faces.size());
  for (Index h = 0; h < across.size(); ++h) {
    const Index other = across[h];
    if (other == no_index || other < h) continue;
    const bool have_same_direction = faces[h / 3][h % 3] == faces[other / 3][other % 3];
    corners.join(h, have_same_direction ? other : next_halfedge(other));
    corners.join(next_halfedge(h), have_same_direction ? next_halfedge(other) : other);
  }

  Umbrellas umbrellas;
  umbrellas.of_corner.assign(3 * faces.size(), no_index);
  for (Index corner = 0; corner < umbrellas.of_corner.size(); ++corner) {
    if (!included.empty() && !included[corner / 3]) continue;
    const Index first = corners.find(corner);
    if (first == corner) {
      umbrellas.of_corner[corner] = static_cast<Index>(umbrellas.vertex_of.size());
      umbrellas.vertex_of.push_back(faces[corner / 3][corner % 3]);
    } else {
      umbrellas.of_corner[corner] = umbrellas.of_corner[first];
    }
  }
  return umbrellas;
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

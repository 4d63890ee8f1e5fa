#include "tm/mesh/fans.h"

#include <algorithm>

namespace transformesh {
namespace {

/// The corner at which the halfedge's face touches the end of the halfedge that is `vertex`.
Index corner_at(const Mesh& mesh, Index halfedge, Index vertex) {
  return halfedge_source(mesh, halfedge) == vertex ? halfedge : next_halfedge(halfedge);
}

}  // namespace

Fans find_fans(const Mesh& mesh, const Edges& edges) {
  Fans fans{DisjointSets(3 * mesh.faces.size()), std::vector<Index>(mesh.positions.size(), 0)};

  // Every corner starts a fan of its own; every join removes one.
  for (const Face& face : mesh.faces)
    for (const Index vertex : face) ++fans.count[vertex];
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    const auto halfedges = edges.halfedges(edge);
    if (halfedges.size() != 2) continue;
    for (const Index vertex :
         {halfedge_source(mesh, halfedges[0]), halfedge_target(mesh, halfedges[0])})
      if (fans.corners.join(corner_at(mesh, halfedges[0], vertex),
                            corner_at(mesh, halfedges[1], vertex)))
        --fans.count[vertex];
  }
  return fans;
}

std::vector<Index> boundary_loops(const Mesh& mesh, const Edges& edges, Fans fans) {
  // Border edges that share a fan belong to one loop.
  std::vector<Index> border;
  for (std::size_t edge = 0; edge < edges.size(); ++edge)
    if (edges.halfedges(edge).size() == 1) border.push_back(edges.halfedges(edge)[0]);
  DisjointSets& loops = fans.corners;
  for (const Index halfedge : border) loops.join(halfedge, next_halfedge(halfedge));

  // The first halfedge of each set in ascending order.
  std::sort(border.begin(), border.end());
  std::vector<Index> firsts;
  std::vector<bool> is_counted(3 * mesh.faces.size(), false);
  for (const Index halfedge : border) {
    const Index loop = loops.find(halfedge);
    if (!is_counted[loop]) firsts.push_back(halfedge);
    is_counted[loop] = true;
  }
  return firsts;
}

}  // namespace transformesh

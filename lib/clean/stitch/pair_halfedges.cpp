#include "clean/stitch/pair_halfedges.h"

#include <map>

#include "clean/exterior/angular_order.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t edges_per_task = 4096;  ///< affects time only

// Pairs the halfedges of an edge of more than two pieces (triangles). In angular order around the
// edge, the inside is between a piece that traverses the edge backward and the next piece that
// traverses it forward. Hence backward and forward halfedges are matched like opening and closing
// brackets on a circle.
void pair_singular_edge(std::span<const Face> faces, const std::vector<Index>& sorted,
                        std::vector<Index>& opposite) {
  std::vector<Index> open;
  for (std::size_t i = 0; i < 2 * sorted.size(); ++i) {
    const Index h = sorted[i % sorted.size()];
    if (opposite[h] != no_index) continue;
    if (!is_forward(faces, h)) {
      if (i < sorted.size()) open.push_back(h);
    } else if (!open.empty()) {
      opposite[h] = open.back();
      opposite[open.back()] = h;
      open.pop_back();
    }
  }
}

// Pairs two sets of halfedges of one edge. The first set are the halfedges of the closed part
// (faces without an open component). The second set are those of each open component with exactly
// two pieces at the edge. The caller pairs the remaining halfedges, regardless of their components.
void pair_components(std::span<const Face> faces, const std::vector<Index>& sorted,
                     std::span<const Index> component_of, std::vector<Index>& opposite) {
  std::map<Index, std::vector<Index>> of_component;
  for (const Index h : sorted) of_component[component_of[h / 3]].push_back(h);
  for (const auto& [component, halfedges] : of_component)
    if (component == no_index || halfedges.size() == 2)
      pair_singular_edge(faces, halfedges, opposite);
}

}  // namespace

std::vector<Index> pair_across_inside(std::span<const Face> faces, const Edges& edges,
                                      const AngularSort& sort,
                                      std::span<const Index> component_of) {
  std::vector<Index> opposite(3 * faces.size(), no_index);
  const auto pair = [&](std::span<const Index> halfedges) {
    if (halfedges.size() > 2) {
      const std::vector<Index> sorted = sort(halfedges);
      if (!component_of.empty()) pair_components(faces, sorted, component_of, opposite);
      pair_singular_edge(faces, sorted, opposite);
    } else if (halfedges.size() == 2 &&
               is_forward(faces, halfedges[0]) != is_forward(faces, halfedges[1])) {
      opposite[halfedges[0]] = halfedges[1];
      opposite[halfedges[1]] = halfedges[0];
    }
  };
  parallel_for(edges.size(), edges_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t e = first; e < last; ++e) pair(edges.halfedges(e));
  });
  return opposite;
}

}  // namespace transformesh

#include "fill/halfedge_stars.h"

#include <algorithm>

namespace transformesh {

HalfedgeStars::HalfedgeStars(const Mesh& mesh, std::vector<Index> opposites)
    : opposites_(std::move(opposites)), leaving_(mesh.positions.size(), no_index) {
  for (Index h = 0; h < opposites_.size(); ++h) leaving_[halfedge_source(mesh, h)] = h;
}

std::vector<Index> HalfedgeStars::from(const Mesh& mesh, Index vertex, Index first) const {
  std::vector<Index> halfedges;
  visit(vertex, [&](Index h) { halfedges.push_back(h); });
  const auto start = std::find_if(halfedges.begin(), halfedges.end(),
                                  [&](Index h) { return halfedge_target(mesh, h) == first; });
  std::rotate(halfedges.begin(), start, halfedges.end());
  return halfedges;
}

}  // namespace transformesh

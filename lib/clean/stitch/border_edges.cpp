#include "clean/stitch/border_edges.h"

#include <algorithm>

#include "mesh/edges.h"

namespace transformesh {
namespace {

std::vector<Index> border_halfedges(const Mesh& mesh) {
  const Edges edges(without_collapsed(mesh.faces), mesh.positions.size());
  std::vector<Index> halfedges;
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (edges.halfedges(e).size() == 1) halfedges.push_back(edges.halfedges(e)[0]);
  return halfedges;
}

}  // namespace

BorderEdges::BorderEdges(const Mesh& mesh)
    : mesh_(mesh), halfedges_(border_halfedges(mesh)), frame_(mesh.positions) {
  std::vector<FloatBox> boxes;
  for (const Index h : halfedges_) {
    const Index a = halfedge_source(mesh, h), b = halfedge_target(mesh, h);
    vertices_.insert(vertices_.end(), {a, b});
    const Vec3 &p = mesh.positions[a], &q = mesh.positions[b];
    boxes.push_back(frame_.box(p.cwiseMin(q), p.cwiseMax(q)));
  }
  std::ranges::sort(vertices_);
  vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
  bvh_ = Bvh(boxes);
}

void BorderEdges::visit_near(Index vertex, double distance,
                             const std::function<void(const Near&)>& visit) const {
  const Vec3& point = mesh_.positions[vertex];
  const Vec3 margin = Vec3::Constant(distance);
  bvh_.visit_overlaps(frame_.box(point - margin, point + margin), [&](Index i) {
    const Index h = halfedges_[i];
    const Index a = halfedge_source(mesh_, h), b = halfedge_target(mesh_, h);
    if (a == vertex || b == vertex) return true;
    const Vec3 &p = mesh_.positions[a], edge = mesh_.positions[b] - p;
    const double along = std::clamp(edge.dot(point - p) / edge.squaredNorm(), 0.0, 1.0);
    const double apart = (p + along * edge - point).norm();
    if (apart <= distance) visit({h, apart, along});
    return true;
  });
}

}  // namespace transformesh

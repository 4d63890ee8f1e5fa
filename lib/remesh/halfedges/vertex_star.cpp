#include "remesh/halfedges/vertex_star.h"

#include <algorithm>

#include "remesh/halfedges/vertex_rings.h"

namespace transformesh {

void VertexStar::gather(const EditableMesh& mesh, Index vertex) {
  find_ring(mesh, vertex, own_ring_);
  gather(mesh, vertex, own_ring_);
}

void VertexStar::gather(const EditableMesh& mesh, Index vertex, std::span<const Index> neighbors) {
  ring_ = neighbors;
  center_ = mesh.position(vertex);
  const std::size_t needed = neighbors.size() / 2 + 1;
  if (pairs_.size() < needed) pairs_.resize(2 * needed);
  measure_neighbors(mesh);
  measure_triangles();
}

void VertexStar::measure_neighbors(const EditableMesh& mesh) {
  const VectorPair center = twice_vector(center_);
  NumberPair farthest = twice(0);
  Pair* pair = pairs_.data();
  for (std::size_t i = 0; i < ring_.size(); i += 2, ++pair) {
    const Vec3& p = mesh.position(ring_[i]);
    const Vec3& q = mesh.position(ring_[std::min(i + 1, ring_.size() - 1)]);
    pair->rim =
        VectorPair{NumberPair{p.x(), q.x()}, NumberPair{p.y(), q.y()}, NumberPair{p.z(), q.z()}};
    pair->way = pair->rim - center;
    pair->way_squared = pair->way.squared();
    farthest = greater(farthest, pair->way_squared);
  }
  reach_squared_ = std::max(farthest[0], farthest[1]);
}

void VertexStar::measure_triangles() {
  Pair* const pairs = pairs_.data();
  double x = 0, y = 0, z = 0;
  for (std::size_t k = 0; k < pair_count(); ++k) {
    Pair& pair = pairs[k];
    const Pair& next = pairs[k + 1];
    const VectorPair& a = pair.way;
    const VectorPair b = middle(pair.way, next.way);
    pair.normal = a.cross(b);
    pair.squared = pair.normal.squared();
    pair.across_squared = (b - a).squared();
    pair.squares =
        pair.way_squared + middle(pair.way_squared, next.way_squared) + pair.across_squared;
    x += pair.normal.x[0];
    y += pair.normal.y[0];
    z += pair.normal.z[0];
    if (2 * k + 1 == size()) break;
    x += pair.normal.x[1];
    y += pair.normal.y[1];
    z += pair.normal.z[1];
  }
  normal_ = {x, y, z};
}

}  // namespace transformesh

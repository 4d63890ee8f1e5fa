#include "remesh/operations/smooth.h"

#include <algorithm>
#include <cmath>

#include "geometry/search/closest_point.h"
#include "remesh/operations/curved_edge.h"
#include "remesh/operations/vertex_mover.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

/// Movements shorter than this share of the square root of the star's doubled area are skipped.
constexpr double rest = 5e-3;
/// Smaller weights of edges, which may be negative, are replaced by this weight.
constexpr double least_weight = 0.01;
constexpr std::size_t things_per_task = 2048;  ///< affects time only

class Relaxer {
 public:
  Relaxer(EditableMesh& mesh, EmbeddingGuard& guard, const VertexRoles& roles,
          const ClosestPointQuery* surface, bool curved)
      : mesh_(mesh), roles_(roles), surface_(surface), curved_(curved), mover_(mesh, guard) {}

  SmoothCounts run(const Progress& progress) {
    SmoothCounts counts;
    const VertexRings rings(mesh_);
    for (Index v = 0; v < mesh_.vertex_slots(); ++v) {
      if (v % 8192 == 0) progress("smooth", static_cast<double>(v) / mesh_.vertex_slots());
      if (!mesh_.has_vertex(v)) continue;
      const VertexRole role = roles_[v];
      if (role == VertexRole::fixed) continue;
      star_.gather(mesh_, v, rings[v]);
      const Vec3 target = role == VertexRole::free ? on_surface(v, free_target()) : line_target(v);
      if ((target - star_.center()).squaredNorm() < rest * rest * star_.normal().norm()) continue;
      if (mover_.move(v, star_, target)) {
        ++counts.moved;
        carry_attributes(v);
      } else {
        ++counts.refused;
      }
    }
    return counts;
  }

 private:
  Vec3 free_target() const;
  Vec3 on_surface(Index vertex, const Vec3& target) const {
    if (surface_ != nullptr) return (*surface_)(target).point;
    return curved_ ? lifted_onto_surface(mesh_, vertex, target) : target;
  }
  Vec3 line_target(Index vertex) const;
  void carry_attributes(Index vertex);

  EditableMesh& mesh_;
  const VertexRoles& roles_;
  const ClosestPointQuery* surface_;
  bool curved_;
  VertexMover mover_;
  VertexStar star_;
};

Vec3 Relaxer::free_target() const {
  // The mean (x, y, z) of the centroids of the triangles, weighted by area, relative to the old
  // position.
  double x = 0, y = 0, z = 0, weight = 0;
  const VertexStar::Pair* const pairs = star_.pairs();
  for (std::size_t i = 0; i < star_.size(); i += 2) {
    const VertexStar::Pair& pair = pairs[i / 2];
    const NumberPair area = square_roots(pair.squared);
    const VectorPair both = pair.way + middle(pair.way, pairs[i / 2 + 1].way);
    const VectorPair weighted{area * both.x, area * both.y, area * both.z};
    for (std::size_t k = 0; k < std::min<std::size_t>(2, star_.size() - i); ++k) {
      x += weighted.x[k];
      y += weighted.y[k];
      z += weighted.z[k];
      weight += area[k];
    }
  }
  if (weight == 0) return star_.center();
  const Vec3 shift = Vec3(x, y, z) / (2 * weight);
  const Vec3& normal = star_.normal();
  const double squared = normal.squaredNorm();
  const double along = squared > 0 ? shift.dot(normal) / squared : 0;
  return star_.center() + shift - along * normal;
}

Vec3 Relaxer::line_target(Index vertex) const {
  const auto [before, after] = roles_.line_neighbors(vertex);
  const Vec3& first = mesh_.position(before);
  const Vec3 along = mesh_.position(after) - first;
  const Vec3 shift = first + 0.5 * along - star_.center();
  return star_.center() + shift.dot(along) / along.squaredNorm() * along;
}

void Relaxer::carry_attributes(Index vertex) {
  if (!mesh_.has_vertex_attributes()) return;
  // Finds the triangle of the old star that contains the new position or is nearest to it. In this
  // triangle, the least barycentric coordinate of the position is largest.
  const Vec3 shift = mesh_.position(vertex) - star_.center();
  double best = -HUGE_VAL;
  std::array<Index, 3> sources{vertex, vertex, vertex};
  std::array<double, 3> weights{1, 0, 0};
  mesh_.for_each_outgoing(vertex, [&](Index halfedge) {
    const Vec3 a = mesh_.position(mesh_.target(halfedge)) - star_.center();
    const Vec3 b = mesh_.position(mesh_.apex(halfedge)) - star_.center();
    const Vec3 normal = a.cross(b);
    const double squared = normal.squaredNorm();
    if (squared == 0) return;
    const double u = shift.cross(b).dot(normal) / squared;
    const double w = a.cross(shift).dot(normal) / squared;
    const double least = std::min({u, w, 1 - u - w});
    if (least <= best) return;
    best = least;
    sources = {vertex, mesh_.target(halfedge), mesh_.apex(halfedge)};
    const double kept = std::clamp(u, 0.0, 1.0);
    const double other = std::clamp(w, 0.0, 1 - kept);
    weights = {1 - kept - other, kept, other};
  });
  mesh_.blend_attributes(vertex, sources, weights);
}

/// The normalized Laplace-Beltrami operator: at each vertex, its value minus the weighted mean of
/// the values of its neighbors.
class Laplacian {
 public:
  Laplacian(const EditableMesh& mesh, const VertexRoles& roles) : mesh_(mesh), roles_(roles) {
    cotangents_.assign(mesh.halfedge_slots(), 0);
    parallel_for(mesh.halfedge_slots(), things_per_task, [&](std::size_t first, std::size_t last) {
      for (auto h = static_cast<Index>(first); h < last; ++h) {
        if (!mesh.has_halfedge(h)) continue;
        const Vec3& apex = mesh.position(mesh.apex(h));
        cotangents_[h] = clamped_cotangent(mesh.position(mesh.source(h)) - apex,
                                           mesh.position(mesh.target(h)) - apex);
      }
    });
  }

  Vec3 apply(const std::vector<Vec3>& values, Index vertex, VertexRole role) const {
    Vec3 sum = Vec3::Zero();
    double total = 0;
    mesh_.for_each_neighbor(vertex, [&](Index neighbor, Index halfedge) {
      if (role == VertexRole::on_line && !is_line(mesh_, halfedge)) return;
      const double w = role == VertexRole::on_line ? 1 : weight(halfedge);
      sum += w * (values[neighbor] - values[vertex]);
      total += w;
    });
    return sum / -total;
  }

  std::vector<Vec3> apply(const std::vector<Vec3>& values) const {
    std::vector<Vec3> result(values.size(), Vec3::Zero());
    parallel_for(values.size(), things_per_task, [&](std::size_t first, std::size_t last) {
      for (auto v = static_cast<Index>(first); v < last; ++v) {
        if (!mesh_.has_vertex(v)) continue;
        const VertexRole role = roles_[v];
        if (role != VertexRole::fixed) result[v] = apply(values, v, role);
      }
    });
    return result;
  }

 private:
  double weight(Index halfedge) const {
    const Index opposite = mesh_.opposite(halfedge);
    const double across = opposite == no_index ? 0 : cotangents_[opposite];
    return std::max(least_weight, cotangents_[halfedge] + across);
  }

  const EditableMesh& mesh_;
  const VertexRoles& roles_;
  std::vector<double> cotangents_;  ///< cotangent of the angle opposite to each halfedge
};

}  // namespace

SmoothCounts relax_tangentially(EditableMesh& mesh, EmbeddingGuard& guard, const VertexRoles& roles,
                                const ClosestPointQuery* surface, const Progress& progress,
                                bool curved) {
  return Relaxer(mesh, guard, roles, surface, curved).run(progress);
}

SmoothCounts smooth_laplace(EditableMesh& mesh, EmbeddingGuard& guard, const VertexRoles& roles,
                            double first, double second, const Progress& progress) {
  progress("smooth", 0);
  const Laplacian laplacian(mesh, roles);
  std::vector<Vec3> positions(mesh.vertex_slots());
  for (Index v = 0; v < mesh.vertex_slots(); ++v) positions[v] = mesh.position(v);
  const std::vector<Vec3> once = laplacian.apply(positions);
  std::vector<Vec3> twice;
  if (second != 0) twice = laplacian.apply(once);

  SmoothCounts counts;
  VertexMover mover(mesh, guard);
  const VertexRings rings(mesh);
  VertexStar star;
  for (Index v = 0; v < mesh.vertex_slots(); ++v) {
    if (v % 8192 == 0) progress("smooth", static_cast<double>(v) / mesh.vertex_slots());
    if (once[v].isZero(0)) continue;
    Vec3 target = positions[v] - first * once[v];
    if (second != 0) target += second * twice[v];
    star.gather(mesh, v, rings[v]);
    const bool moved = mover.move(v, star, target);
    ++(moved ? counts.moved : counts.refused);
  }
  return counts;
}

}  // namespace transformesh

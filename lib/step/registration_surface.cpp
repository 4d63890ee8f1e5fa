#include "step/registration_surface.h"

#include <algorithm>

#include "geometry/surface_samples.h"
#include "mesh/adjacency.h"
#include "step/estimate_normals.h"
#include "step/prepare_target.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// Fixed seed, so that the result depends on the meshes only.
constexpr std::uint64_t sample_seed = 1;

}  // namespace

std::vector<OrientedPoint> oriented_samples(const Mesh& mesh, std::size_t count) {
  std::vector<OrientedPoint> samples;
  if (!mesh.faces.empty()) {
    for (const SurfacePoint& point : surface_points(mesh, count, sample_seed))
      samples.push_back({point.position, face_normal(mesh, point.face).stableNormalized()});
    return samples;
  }
  const std::vector<Vec3> normals = stored_normals(mesh);
  const std::size_t size = mesh.positions.size();
  const std::size_t taken = std::min(count, size);
  for (std::size_t i = 0; i < taken; ++i) {
    const std::size_t v = i * size / taken;
    samples.push_back({mesh.positions[v], normals.empty() ? Vec3::Zero() : normals[v]});
  }
  return samples;
}

RegistrationSurface::RegistrationSurface(const Mesh& mesh) : mesh_(mesh) {
  if (mesh.faces.empty()) {
    points_.emplace(mesh.positions);
    normals_ = stored_normals(mesh);
    if (normals_.empty()) normals_ = estimate_normals(mesh.positions);
    return;
  }
  surface_.emplace(mesh);
  border_edges_.resize(3 * mesh.faces.size());
  border_vertices_.resize(mesh.positions.size());
  const std::vector<Index> opposites = opposite_halfedges(mesh);
  for (Index h = 0; h < opposites.size(); ++h) {
    if (opposites[h] != no_index) continue;
    border_edges_[h] = true;
    border_vertices_[halfedge_source(mesh, h)] = true;
    border_vertices_[halfedge_target(mesh, h)] = true;
  }
}

bool RegistrationSurface::is_on_border(const Vec3& query, Index face) const {
  const Face& corners = mesh_.faces[face];
  const auto part =
      closest_point_of_triangle(query, mesh_.positions[corners[0]], mesh_.positions[corners[1]],
                                mesh_.positions[corners[2]])
          .part;
  if (part == TriangleSimplex::inside) return false;
  const auto number = static_cast<std::size_t>(part);
  if (part <= TriangleSimplex::corner_2) return border_vertices_[corners[number]];
  return border_edges_[3 * face + (number - 3)];
}

RegistrationSurface::Partner RegistrationSurface::closest(const Vec3& query) const {
  if (points_) {
    const Index nearest = points_->nearest(query);
    return {{mesh_.positions[nearest], normals_[nearest]}, false};
  }
  const ClosestPoint found = (*surface_)(query);
  return {{found.point, found.pseudonormal}, is_on_border(query, found.face)};
}

}  // namespace transformesh

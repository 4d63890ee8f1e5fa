#include "step/morph_velocities.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/search/closest_point.h"
#include "geometry/search/hilbert.h"
#include "mesh/adjacency.h"
#include "step/sample_distance.h"
#include "step/target_query.h"
#include "support/elementary/exponential.h"
#include "support/parallel.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

constexpr std::size_t queries_per_task = 512;  ///< affects time only
/// Number of tangent planes of the target that decide on which side of the target a point is, if
/// the point is far away. With fewer planes, points beyond the tip of a thin part of the target are
/// taken to be inside it.
constexpr std::size_t planes_of_points = 12;
/// Largest number of target vertices in distance_from_target(). With more vertices, the summary is
/// more accurate and takes more time.
constexpr std::size_t most_vertices_of_target = 1024;

constexpr double unlimited_room = std::numeric_limits<double>::infinity();

/// Results of the searches from all vertices of the mesh.
struct Found {
  std::vector<double> distances;
  /// Thickness of the target at the closest points; empty if it is not measured.
  std::vector<double> thickness;
};

std::vector<double> room_for_thickness(const Mesh& mesh, const Target& target) {
  std::vector<double> room;
  if (!target.thickness.empty()) room.assign(mesh.positions.size(), unlimited_room);
  return room;
}

Found search_surface(const Mesh& mesh, const TargetQuery& query, double exact_within,
                     std::span<const Index> order) {
  const Target& target = query.target();
  const ClosestPointQuery& closest = query.surface();
  Found found{{}, room_for_thickness(mesh, target)};
  // Approximate searches get no hint, because their result would depend on the hint.
  const auto search = [&](Index v, double sign, Index hint) {
    const Vec3& p = mesh.positions[v];
    if (sign != 0) return searched_distance(p, closest.nearby(p, far_tolerance), sign);
    const ClosestPoint q = closest(p, hint);
    if (!target.thickness.empty()) {
      const auto& [a, b, c] = target.mesh.faces[q.face];
      found.thickness[v] =
          std::min({target.thickness[a], target.thickness[b], target.thickness[c]});
    }
    SearchedDistance result = searched_distance(p, q.point, q.signed_distance < 0 ? -1 : 1);
    result.face = q.face;
    return result;
  };
  found.distances = sample_distance(mesh.positions, order, exact_within, search);
  return found;
}

/// Returns the signed distance to the target's tangent planes at the vertices `nearest`, nearest
/// first. Near the surface this is the distance to the first plane. If the point is farther from
/// the target than samples are from each other, the weighted mean over all planes decides the side.
/// The mean replaces the distance to the first plane if the signs differ.
double distance_to_planes(const Vec3& p, std::span<const Vec3> points,
                          std::span<const Vec3> normals, std::span<const Index> nearest) {
  const auto squared = [&](Index q) { return (p - points[q]).squaredNorm(); };
  const auto to_plane = [&](Index q) { return (p - points[q]).dot(normals[q]); };
  const double least = squared(nearest.front());
  const double spread = squared(nearest.back()) - least;
  const double to_nearest = to_plane(nearest.front());
  if (4 * least <= spread || nearest.size() == 1) return to_nearest;

  double sum = 0;
  double weights = 0;
  for (const Index q : nearest) {
    const double weight = spread > 0 ? elementary::exp(-2 * (squared(q) - least) / spread) : 1;
    sum += weight * to_plane(q);
    weights += weight;
  }
  const bool is_same_side = (sum < 0) == (to_nearest < 0);
  return is_same_side ? to_nearest : sum / weights;
}

// Searches the target from every vertex. The distance to tangent planes is not continuous, so it
// cannot be estimated from the distances of other vertices.
Found search_vertices(const Mesh& mesh, const TargetQuery& query, std::size_t planes,
                      std::span<const Index> order) {
  const Target& target = query.target();
  const KdTree& tree = query.vertices();
  const std::vector<Vec3>& normals = query.normals();
  Found found{std::vector<double>(mesh.positions.size()), room_for_thickness(mesh, target)};
  parallel_for(order.size(), queries_per_task, [&](std::size_t first, std::size_t last) {
    for (const Index v : order.subspan(first, last - first)) {
      const Vec3& p = mesh.positions[v];
      const std::vector<Index> nearest = tree.nearest(p, planes);
      found.distances[v] = distance_to_planes(p, target.mesh.positions, normals, nearest);
      if (!target.thickness.empty()) found.thickness[v] = target.thickness[nearest.front()];
    }
  });
  return found;
}

Vec3 closest_around_vertex(const Vec3& query, const Mesh& mesh, Index vertex,
                           std::span<const Index> faces) {
  Vec3 closest = mesh.positions[vertex];
  for (const Index f : faces) {
    const Face& face = mesh.faces[f];
    const Vec3 point = closest_point_of_triangle(query, mesh.positions[face[0]],
                                                 mesh.positions[face[1]], mesh.positions[face[2]])
                           .point;
    if ((point - query).squaredNorm() < (closest - query).squaredNorm()) closest = point;
  }
  return closest;
}

/// Returns every k-th point, with the least k that leaves at most `most` points.
std::vector<Vec3> thinned(std::span<const Vec3> points, std::size_t most) {
  const std::size_t stride = (points.size() + most - 1) / most;
  std::vector<Vec3> result;
  for (std::size_t i = 0; i < points.size(); i += stride) result.push_back(points[i]);
  return result;
}

/// Summarizes `count` distances; all other entries of `distances` are 0.
DistanceSummary summary(std::span<const double> distances, std::size_t count) {
  DistanceSummary result;
  double squares = 0;
  for (const double distance : distances) {
    result.maximum = std::max(result.maximum, std::abs(distance));
    squares += distance * distance;
  }
  if (count > 0) result.rms = std::sqrt(squares / static_cast<double>(count));
  return result;
}

}  // namespace

std::vector<Index> surface_order(const Mesh& mesh) {
  std::vector<char> is_used(mesh.positions.size(), 0);
  for (const Face& face : mesh.faces)
    for (const Index v : face) is_used[v] = 1;
  std::vector<Index> order = hilbert_order(mesh.positions);
  std::erase_if(order, [&](Index v) { return is_used[v] == 0; });
  return order;
}

MorphVelocities morph_velocities(const Mesh& mesh, const TargetQuery& target,
                                 const MorphVelocityOptions& options, const Progress& progress,
                                 std::vector<Index> order) {
  if (mesh.faces.empty()) throw InputError("the mesh has no faces to move");
  const bool by_surface = options.distance == MorphDistance::surface;
  if (by_surface && !target.target().is_mesh()) {
    throw UsageError("the target has no faces: only the distance to its vertices is known");
  }

  progress("distance to target");
  const std::size_t planes = options.distance == MorphDistance::points ? planes_of_points : 1;
  std::vector<Vec3> normals = vertex_normals(mesh);
  if (order.empty()) order = surface_order(mesh);
  Found found = by_surface ? search_surface(mesh, target, options.exact_within, order)
                           : search_vertices(mesh, target, planes, order);

  const std::vector<double>& phi = found.distances;
  MorphVelocities result{std::move(normals), summary(phi, order.size()),
                         std::move(found.thickness)};
  for (std::size_t v = 0; v < phi.size(); ++v) result.velocities[v] *= -phi[v];
  return result;
}

DistanceSummary distance_from_target(const Target& target, const Mesh& mesh, double exact_within,
                                     const Progress& progress, std::vector<Index> order) {
  if (mesh.faces.empty()) throw InputError("the mesh has no faces");
  progress("distance from target");
  if (order.empty()) order = surface_order(mesh);
  const KdTree tree(mesh.positions, order);
  const VertexFaces faces_at(mesh);
  const std::vector<Vec3> points = thinned(target.mesh.positions, most_vertices_of_target);
  const auto search = [&](Index point, double, Index) {
    const Vec3& p = points[point];
    const Index nearest = tree.nearest(p);
    return searched_distance(p, closest_around_vertex(p, mesh, nearest, faces_at[nearest]));
  };
  return summary(sample_distance(points, hilbert_order(points), exact_within, search),
                 points.size());
}

}  // namespace transformesh

#include "tm/geometry/closest_point.h"

#include <Eigen/Geometry>
#include <limits>

#include "tm/geometry/median_tree_visit.h"
#include "tm/mesh/adjacency.h"
#include "tm/mesh/measure.h"
#include "tm/support/error.h"
#include "tm/support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t bucket_size = 2;
constexpr std::size_t faces_per_task = 4096;

TrianglePart corner_part(int corner) { return static_cast<TrianglePart>(corner % 3); }
TrianglePart edge_part(int edge) { return static_cast<TrianglePart>(3 + edge); }

/// The closest point of the segment from corner `edge` of the triangle to the next.
TrianglePoint closest_point_of_edge(const Vec3& query, const Vec3& from, const Vec3& to, int edge) {
  const Vec3 direction = to - from;
  const double along = direction.dot(query - from);
  const double length_squared = direction.squaredNorm();
  if (!(along > 0)) return {from, corner_part(edge)};
  if (!(along < length_squared)) return {to, corner_part(edge + 1)};
  return {from + along / length_squared * direction, edge_part(edge)};
}

double squared_distance(const Vec3& a, const Vec3& b) {
  return MedianTree::squared_length(a.x() - b.x(), a.y() - b.y(), a.z() - b.z());
}

std::vector<Vec3> unit_face_normals(const Mesh& mesh) {
  std::vector<Vec3> normals(mesh.faces.size());
  parallel_for(normals.size(), faces_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f)
      normals[f] = face_normal(mesh, static_cast<Index>(f)).stableNormalized();
  });
  return normals;
}

const Mesh& checked(const Mesh& mesh) {
  if (mesh.faces.empty())
    throw InputError("the mesh has no faces, and so no closest point; a surface is needed");
  return mesh;
}

}  // namespace

TrianglePoint closest_point_of_triangle(const Vec3& query, const Vec3& a, const Vec3& b,
                                        const Vec3& c) {
  // Barycentric coordinates of the projection, times the squared normal.
  const Vec3 to_a = a - query;
  const Vec3 to_b = b - query;
  const Vec3 to_c = c - query;
  const Vec3 normal = (b - a).cross(c - a);
  const double weight_a = normal.dot(to_b.cross(to_c));
  const double weight_b = normal.dot(to_c.cross(to_a));
  const double weight_c = normal.dot(to_a.cross(to_b));
  if (weight_a > 0 && weight_b > 0 && weight_c > 0) {
    const double sum = weight_a + weight_b + weight_c;
    return {a + weight_b / sum * (b - a) + weight_c / sum * (c - a), TrianglePart::inside};
  }

  // Else the closest point lies on the boundary; the first of equals.
  const std::array<TrianglePoint, 3> candidates{closest_point_of_edge(query, a, b, 0),
                                                closest_point_of_edge(query, b, c, 1),
                                                closest_point_of_edge(query, c, a, 2)};
  TrianglePoint best = candidates[0];
  for (const TrianglePoint& candidate : {candidates[1], candidates[2]})
    if (squared_distance(candidate.point, query) < squared_distance(best.point, query))
      best = candidate;
  return best;
}

ClosestPointQuery::ClosestPointQuery(const Mesh& mesh)
    : mesh_(&checked(mesh)),
      tree_(face_boxes(mesh), bucket_size),
      face_normals_(unit_face_normals(mesh)),
      vertex_normals_(vertex_normals(mesh)),
      opposite_(opposite_halfedges(mesh)) {}

ClosestPoint ClosestPointQuery::operator()(const Vec3& query) const {
  double best_squared = std::numeric_limits<double>::infinity();
  Index best_face = no_index;
  TrianglePoint best;
  tree_.visit_nearest(
      query, [&] { return best_squared; },
      [&](std::size_t place) {
        const Index face = tree_.order()[place];
        const auto& [a, b, c] = mesh_->faces[face];
        const TrianglePoint candidate = closest_point_of_triangle(
            query, mesh_->positions[a], mesh_->positions[b], mesh_->positions[c]);
        const double candidate_squared = squared_distance(candidate.point, query);
        if (candidate_squared > best_squared) return;
        if (candidate_squared == best_squared && face > best_face) return;
        best_squared = candidate_squared;
        best_face = face;
        best = candidate;
      });

  ClosestPoint result;
  result.point = best.point;
  result.face = best_face;
  result.distance = (query - best.point).norm();
  result.pseudonormal = pseudonormal(best_face, best.part);
  const bool is_behind = result.pseudonormal.dot(query - best.point) < 0;
  result.signed_distance = is_behind ? -result.distance : result.distance;
  return result;
}

Vec3 ClosestPointQuery::pseudonormal(Index face, TrianglePart part) const {
  if (part == TrianglePart::inside) return face_normals_[face];
  const auto number = static_cast<Index>(part);
  if (number < 3) return vertex_normals_[mesh_->faces[face][number]];
  const Index across = opposite_[3 * face + number - 3];
  if (across == no_index) return face_normals_[face];
  return (face_normals_[face] + face_normals_[across / 3]).stableNormalized();
}

}  // namespace transformesh

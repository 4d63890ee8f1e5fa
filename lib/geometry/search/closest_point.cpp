#include "geometry/search/closest_point.h"

#include <Eigen/Geometry>
#include <limits>

#include "geometry/search/median_tree_visit.h"
#include "mesh/local_measures.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

constexpr std::size_t faces_per_leaf =
    2;  ///< number of faces per leaf of the tree; affects time only

/// An angle between normals counts as less than 90 degrees if its cosine exceeds this value, which
/// is larger than the rounding error of a right angle.
constexpr double least_cosine = 1e-9;

TriangleSimplex corner_simplex(int corner) { return static_cast<TriangleSimplex>(corner % 3); }
TriangleSimplex edge_simplex(int edge) { return static_cast<TriangleSimplex>(3 + edge); }

/// Returns the point closest to the query on edge number `edge` of a triangle, from corner `from`
/// to corner `to`.
inline TrianglePoint closest_point_of_edge(const Vec3& query, const Vec3& from, const Vec3& to,
                                           int edge) {
  const Vec3 direction = to - from;
  const double along = direction.dot(query - from);
  const double length_squared = direction.squaredNorm();
  if (!(along > 0)) return {from, corner_simplex(edge)};
  if (!(along < length_squared)) return {to, corner_simplex(edge + 1)};
  return {from + along / length_squared * direction, edge_simplex(edge)};
}

double squared_distance(const Vec3& a, const Vec3& b) {
  return MedianTree::squared_length(a.x() - b.x(), a.y() - b.y(), a.z() - b.z());
}

bool accept_all(const Vec3&, const Vec3&, const Vec3&) { return true; }

const Mesh& checked(const Mesh& mesh) {
  if (mesh.faces.empty())
    throw InputError("the mesh has no faces, and so no closest point; a surface is needed");
  return mesh;
}

}  // namespace

TrianglePoint closest_point_of_triangle(const Vec3& query, const Vec3& a, const Vec3& b,
                                        const Vec3& c) {
  // Barycentric coordinates of the projection, times the squared length of the normal.
  const Vec3 to_a = a - query;
  const Vec3 to_b = b - query;
  const Vec3 to_c = c - query;
  const Vec3 normal = (b - a).cross(c - a);
  const double weight_a = normal.dot(to_b.cross(to_c));
  const double weight_b = normal.dot(to_c.cross(to_a));
  const double weight_c = normal.dot(to_a.cross(to_b));
  if (weight_a > 0 && weight_b > 0 && weight_c > 0) {
    const double sum = weight_a + weight_b + weight_c;
    return {a + weight_b / sum * (b - a) + weight_c / sum * (c - a), TriangleSimplex::inside};
  }

  // Otherwise the closest point is on the boundary; ties are broken by order.
  TrianglePoint best = closest_point_of_edge(query, a, b, 0);
  double least = squared_distance(best.point, query);
  const auto offer = [&](const TrianglePoint& candidate) {
    const double squared = squared_distance(candidate.point, query);
    if (!(squared < least)) return;
    best = candidate;
    least = squared;
  };
  offer(closest_point_of_edge(query, b, c, 1));
  offer(closest_point_of_edge(query, c, a, 2));
  return best;
}

std::vector<Index> spatial_face_order(const Mesh& mesh) {
  return MedianTree(face_boxes(mesh), faces_per_leaf).order();
}

ClosestPointQuery::ClosestPointQuery(const Mesh& mesh, FaceOrder order)
    : mesh_(&checked(mesh)),
      tree_(face_boxes(mesh), faces_per_leaf,
            order == FaceOrder::spatial ? BoxOrder::of_tree : BoxOrder::any),
      faces_at_(mesh) {}

struct ClosestPointQuery::Hit {
  double squared = std::numeric_limits<double>::infinity();  ///< squared distance from the query
  Index face = no_index;
  TrianglePoint place;
  Vec3 to_query = Vec3::Zero();  ///< vector from the closest point to the query

  /// True if the corner is beyond the tangent plane, at the closest point, of the sphere around the
  /// query. A margin allows for rounding. A triangle with all corners beyond this plane is not
  /// closer than the closest point.
  bool is_beyond(const Vec3& corner) const {
    return to_query.dot(corner - place.point) < -1e-9 * squared;
  }
};

/// Returns the closest face. Skips faces that `accept` rejects or that are beyond `squared_bound`.
/// Skips tree cells whose squared distance exceeds `shrink` times the best squared distance.
template <class Condition>
ClosestPointQuery::Hit ClosestPointQuery::search(const Vec3& query, double shrink,
                                                 const Condition& accept, Index hint,
                                                 double squared_bound) const {
  Hit best;
  best.squared = squared_bound;
  const auto offer = [&](Index face) {
    const Vec3& a = mesh_->positions[mesh_->faces[face][0]];
    const Vec3& b = mesh_->positions[mesh_->faces[face][1]];
    const Vec3& c = mesh_->positions[mesh_->faces[face][2]];
    if (best.is_beyond(a) && best.is_beyond(b) && best.is_beyond(c)) return;
    if (!accept(a, b, c)) return;
    const TrianglePoint candidate = closest_point_of_triangle(query, a, b, c);
    const double squared = squared_distance(candidate.point, query);
    if (squared > best.squared) return;
    if (squared == best.squared && face > best.face) return;
    best = {squared, face, candidate, query - candidate.point};
  };
  if (hint != no_index) offer(hint);
  tree_.visit_nearest(
      query, [&] { return shrink * best.squared; },
      [&](std::size_t place) { offer(tree_.order()[place]); });
  return best;
}

Index ClosestPointQuery::face_within(const Vec3& query, double distance, Index hint) const {
  const double bound = distance * distance;
  Index found = no_index;
  const auto offer = [&](Index face) {
    if (found != no_index) return;
    const auto& [a, b, c] = mesh_->faces[face];
    const TrianglePoint nearest = closest_point_of_triangle(
        query, mesh_->positions[a], mesh_->positions[b], mesh_->positions[c]);
    if (squared_distance(nearest.point, query) <= bound) found = face;
  };
  if (hint != no_index) offer(hint);
  if (found != no_index) return found;
  tree_.visit_nearest(
      query, [&] { return found != no_index ? -1 : bound; },
      [&](std::size_t place) { offer(tree_.order()[place]); });
  return found;
}

Index ClosestPointQuery::closest_face_within(const Vec3& query, double distance, Index hint) const {
  return search(query, 1, accept_all, hint, distance * distance).face;
}

Vec3 ClosestPointQuery::nearby(const Vec3& query, double tolerance) const {
  return search(query, 1 / ((1 + tolerance) * (1 + tolerance)), accept_all).place.point;
}

ClosestPoint ClosestPointQuery::operator()(const Vec3& query, Index hint) const {
  return described(query, search(query, 1, accept_all, hint));
}

ClosestPoint ClosestPointQuery::facing(const Vec3& query, const Vec3& normal) const {
  const double least = least_cosine * normal.stableNorm();
  const Hit best = search(query, 1, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 other = (b - a).cross(c - a);
    return normal.dot(other) > least * other.stableNorm();
  });
  return best.face == no_index ? (*this)(query) : described(query, best);
}

std::optional<Vec3> ClosestPointQuery::closest_within(const Vec3& query, double distance,
                                                      const Accept& accept) const {
  const Hit best = search(query, 1, accept, no_index, distance * distance);
  if (best.face == no_index) return std::nullopt;
  return best.place.point;
}

ClosestPoint ClosestPointQuery::described(const Vec3& query, const Hit& best) const {
  ClosestPoint result;
  result.point = best.place.point;
  result.face = best.face;
  result.distance = (query - best.place.point).norm();
  result.pseudonormal = pseudonormal(best.face, best.place.part);
  const bool is_behind = result.pseudonormal.dot(query - best.place.point) < 0;
  result.signed_distance = is_behind ? -result.distance : result.distance;
  return result;
}

Vec3 ClosestPointQuery::pseudonormal(Index face, TriangleSimplex part) const {
  Vec3 normal = face_normal(*mesh_, face).stableNormalized();
  if (part == TriangleSimplex::inside) return normal;
  const auto number = static_cast<int>(part);
  const Face& corners = mesh_->faces[face];
  if (number < 3) return vertex_normal(*mesh_, corners[number], faces_at_[corners[number]]);
  const Index across = face_across(face, corners[number - 3], corners[(number - 2) % 3]);
  if (across == no_index) return normal;
  return (normal + face_normal(*mesh_, across).stableNormalized()).stableNormalized();
}

Index ClosestPointQuery::face_across(Index face, Index from, Index to) const {
  Index across = no_index;
  for (const Index other : faces_at_[from]) {
    if (other == face) continue;
    const Face& corners = mesh_->faces[other];
    for (int i = 0; i < 3; ++i) {
      const Index next = corners[(i + 1) % 3];
      const bool has_same_direction = corners[i] == from && next == to;
      if (has_same_direction || (corners[i] == to && next == from)) {
        if (has_same_direction || across != no_index) return no_index;
        across = other;
      }
    }
  }
  return across;
}

}  // namespace transformesh

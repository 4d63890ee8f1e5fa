#include "step/local_thickness.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <limits>
#include <optional>

#include "geometry/search/closest_point.h"
#include "geometry/search/kd_tree.h"
#include "mesh/adjacency.h"
#include "step/prepare_target.h"
#include "step/split_faces.h"
#include "step/target_query.h"
#include "support/parallel.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

constexpr std::size_t vertices_per_task = 64;  ///< affects time only
/// Largest number of times that a ball shrinks. A ball that is then not empty keeps its last
/// diameter, which is too large.
constexpr int most_cuts = 20;

/// A ball shrinks if an opposite sheet reaches deeper into it than this share of the radius. With
/// smaller shares, diameters are more accurate and need more searches.
constexpr double depth = 0.05;

/// Cosine of 120 degrees. Sheets whose normals differ by a larger angle are opposite. With a
/// smaller angle, blunt corners would count as narrow places.
constexpr double facing = -0.5;

/// Cosine of 20 degrees. A face at a vertex is skipped if its normal differs by a smaller angle
/// from a normal that was already tested. A smaller limit takes more time on curved targets, and
/// changes nothing at sharp edges.
constexpr double alike = 0.94;
/// Rounding error of the distance from a point to a face that contains it, relative to coordinates.
constexpr double rounding = 1e-12;
constexpr double wide = std::numeric_limits<double>::infinity();

/// A point of the surface with one of its normals, of unit length.
struct Contact {
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::Zero();
};
/// Returns the closest point to `center` within `distance` that lies on a sheet opposite to the
/// contact.
using Search =
    std::function<std::optional<Vec3>(const Vec3& center, double distance, const Contact& contact)>;

/// Returns the diameter of the largest empty ball that touches the contact and whose center lies
/// along `direction`. Returns infinity if the diameter is not less than `reach`.
double ball_width(const Contact& contact, const Vec3& direction, double reach,
                  const Search& closest) {
  double radius = reach / 2;
  double width = wide;
  for (int cut = 0; cut < most_cuts; ++cut) {
    const Vec3 center = contact.point + radius * direction;
    const std::optional<Vec3> other = closest(center, (1 - depth) * radius, contact);
    if (!other) return width;

    // The next ball is tangent at the contact and passes through *other.
    const Vec3 way = *other - contact.point;
    radius = way.squaredNorm() / (2 * way.dot(direction));
    if (!(radius > 0)) return width;
    width = 2 * radius;
  }
  return width;
}

double width_at(const Contact& contact, double reach, const Search& closest) {
  if (contact.normal.isZero(0)) return wide;
  return std::min(ball_width(contact, contact.normal, reach, closest),
                  ball_width(contact, -contact.normal, reach, closest));
}

std::vector<double> measured(std::size_t count, const std::function<double(Index)>& width) {
  std::vector<double> widths(count);
  parallel_for(count, vertices_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) widths[v] = width(static_cast<Index>(v));
  });
  return widths;
}

/// Returns a search among the faces of a mesh. Faces with a corner at the contact do not count as
/// an opposite sheet, even if the edge between them is sharp.
Search search_of(const ClosestPointQuery& query) {
  return [&query](const Vec3& center, double distance, const Contact& contact) {
    return query.closest_within(
        center, distance, [&contact](const Vec3& a, const Vec3& b, const Vec3& c) {
          const Vec3 normal = (b - a).cross(c - a);
          return normal.dot(contact.normal) < facing * normal.norm() && a != contact.point &&
                 b != contact.point && c != contact.point;
        });
  };
}

Search search_of(const KdTree& tree, const Target& target) {
  return [&](const Vec3& center, double distance, const Contact& contact) -> std::optional<Vec3> {
    const std::vector<Vec3>& points = target.mesh.positions;
    const Index nearest = tree.nearest_within(center, distance, [&](Index other) {
      return target.normals[other].dot(contact.normal) < facing && points[other] != contact.point;
    });
    if (nearest == no_index) return std::nullopt;
    return points[nearest];
  };
}

/// Returns a search that finds nothing if `sides` is `inside` and the center is outside of the
/// surface.
Search within(BallSides sides, const Search& closest) {
  if (sides == BallSides::both) return closest;
  return [closest](const Vec3& center, double distance,
                   const Contact& contact) -> std::optional<Vec3> {
    if ((center - contact.point).dot(contact.normal) > 0) return std::nullopt;
    return closest(center, distance, contact);
  };
}

/// Returns the least thickness at a contact, for its normal and for the normals of those faces
/// whose normals differ from it.
double least_width(const Mesh& mesh, const Contact& first, std::span<const Index> faces,
                   double reach, const Search& closest) {
  std::vector<Vec3> normals{first.normal};
  double width = width_at(first, reach, closest);
  for (const Index f : faces) {
    const Vec3 normal = face_normal(mesh, f).stableNormalized();
    const bool is_known = std::any_of(normals.begin(), normals.end(),
                                      [&](const Vec3& other) { return other.dot(normal) > alike; });
    if (is_known) continue;
    normals.push_back(normal);
    width = std::min(width, width_at({first.point, normal}, reach, closest));
  }
  return width;
}

std::vector<Index> faces_that_contain(const Mesh& mesh, const Vec3& point) {
  const double close = rounding * point.cwiseAbs().maxCoeff();
  std::vector<Index> faces;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const auto& [a, b, c] = mesh.faces[f];
    const Vec3 nearest =
        closest_point_of_triangle(point, mesh.positions[a], mesh.positions[b], mesh.positions[c])
            .point;
    if ((nearest - point).norm() <= close) faces.push_back(f);
  }
  return faces;
}

std::vector<double> thickness_of_mesh(const Mesh& mesh, FaceOrder order, double reach,
                                      BallSides sides) {
  const ClosestPointQuery query(mesh, order);
  const Search closest = within(sides, search_of(query));
  const VertexFaces faces_at(mesh);
  const std::vector<Vec3> normals = vertex_normals(mesh);
  return measured(mesh.positions.size(), [&](Index v) {
    return least_width(mesh, {mesh.positions[v], normals[v]}, faces_at[v], reach, closest);
  });
}

}  // namespace

std::vector<double> local_thickness(const Target& target, double reach, const Progress& progress,
                                    BallSides sides) {
  progress("gaps");
  const Mesh& mesh = target.mesh;
  if (target.is_mesh())
    return thickness_of_mesh(mesh, target.has_spatial_order ? FaceOrder::spatial : FaceOrder::any,
                             reach, sides);
  const KdTree tree(mesh.positions);
  const Search closest = within(sides, search_of(tree, target));
  return measured(mesh.positions.size(), [&](Index v) {
    return width_at({mesh.positions[v], target.normals[v]}, reach, closest);
  });
}

double local_thickness_near(const TargetQuery& target, const Vec3& place, double reach) {
  const Mesh& mesh = target.target().mesh;
  const Search closest = search_of(target.surface());
  const ClosestPoint found = target.surface()(place);
  const Vec3 normal = face_normal(mesh, found.face).stableNormalized();
  std::vector<Vec3> points{found.point};
  for (const Index corner : mesh.faces[found.face])
    if ((mesh.positions[corner] - place).norm() < reach) points.push_back(mesh.positions[corner]);
  double width = wide;
  for (const Vec3& point : points)
    width = std::min(
        width, least_width(mesh, {point, normal}, faces_that_contain(mesh, point), reach, closest));
  return width;
}

Target with_thickness(const Target& target, double gap_edges, double edge,
                      const Progress& progress) {
  Target result = target;
  if (split_faces(result.mesh, std::max(gap_edges, 1.0) * edge / 2)) {
    result.has_spatial_order = false;
    order_spatially(result);
  }
  result.thickness = local_thickness(result, gap_edges * edge, progress);
  return result;
}

}  // namespace transformesh

#include "evolution/miter.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "geometry/search/closest_point.h"
#include "mesh/adjacency.h"
#include "mesh/local_measures.h"
#include "mesh/surface_columns.h"
#include "mesh/triangle.h"
#include "support/empty_result_error.h"
#include "transformesh/clean.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/manifold.h"
#include "transformesh/offset.h"

namespace transformesh {
namespace {

/// Eigenvalues of a vertex's matrix below this fraction of the largest count as 0. Creases of less
/// than 2 degrees then move along their mean normal, which is short by 0.0005 of the distance. With
/// 0.1, creases of up to 35 degrees would move in this way.
constexpr double least_eigenvalue = 1e-3;
/// Longest movement of a vertex, as a multiple of the distance. It is reached at a corner of 30
/// degrees; sharper spikes are cut off.
constexpr double miter_limit = 4;
/// A component is removed if all of it is closer to the source surface than this fraction of the
/// offset distance. Such components result from parts of the source that were turned inside out
/// twice. Offsets of curved surfaces are correct at vertices, and less than 5 % too close between
/// vertices.
constexpr double least_distance = 0.95;

/// A deviation above this fraction of the distance is reported as large. On smooth surfaces,
/// deviations of face planes are smaller. A choice.
constexpr double large_deviation = 0.05;

struct Planes {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Vec3 right = Vec3::Zero();
};

Vec3 solved(const Planes& planes) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(planes.matrix);
  Vec3 way = Vec3::Zero();
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double value = solver.eigenvalues()[k];
    if (value <= least_eigenvalue * solver.eigenvalues()[2]) continue;
    const Vec3 direction = solver.eigenvectors().col(k);
    way += direction * (direction.dot(planes.right) / value);
  }
  const double length = way.norm();
  return length > miter_limit ? Vec3(way * (miter_limit / length)) : way;
}

/// Returns the largest error, and its location, of a movement by distance * directions. The error
/// of a face is the difference between `distance` and the movement of the face's plane.
MiterDeviation deviation_of(const Mesh& mesh, const std::vector<Vec3>& directions,
                            double distance) {
  MiterDeviation worst;
  for (const Face& face : mesh.faces) {
    const Vec3& a = mesh.positions[face[0]];
    const Vec3 u = (mesh.positions[face[1]] - a).stableNormalized();
    const Vec3 v = (mesh.positions[face[2]] - a).stableNormalized();
    const Vec3 normal = u.cross(v).stableNormalized();
    if (!(normal.squaredNorm() > 0)) continue;
    for (const Index corner : face) {
      const double difference = std::abs(distance * (normal.dot(directions[corner]) - 1));
      if (difference > worst.most) worst = {difference, mesh.positions[corner], false, {}};
    }
  }
  worst.is_large = worst.most > large_deviation * std::abs(distance);
  return worst;
}

void move(Mesh& mesh, const std::vector<Vec3>& directions, double distance) {
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    mesh.positions[v] += distance * directions[v];
}

/// Appends a reversed copy of the mesh, moved by `distance` * directions, and walls along the
/// borders.
void append_other_side(Mesh& mesh, const std::vector<Vec3>& directions, double distance) {
  const std::vector<Index> opposites = opposite_halfedges(mesh);
  const auto count = static_cast<Index>(mesh.positions.size());
  const std::size_t faces = mesh.faces.size();
  std::vector<Index> rows;
  for (Index f = 0; f < faces; ++f) rows.push_back(f);
  for (Index v = 0; v < count; ++v)
    mesh.positions.emplace_back(mesh.positions[v] + distance * directions[v]);
  for (std::size_t f = 0; f < faces; ++f) {
    const auto [a, b, c] = mesh.faces[f];
    mesh.faces.push_back({a + count, c + count, b + count});
    rows.push_back(static_cast<Index>(f));
  }
  for (Index h = 0; h < opposites.size(); ++h) {
    if (opposites[h] != no_index) continue;
    const Index a = mesh.faces[h / 3][h % 3], b = mesh.faces[h / 3][(h + 1) % 3];
    mesh.faces.insert(mesh.faces.end(), {{b, a, a + count}, {b, a + count, b + count}});
    rows.insert(rows.end(), 2, h / 3);
  }
  mesh.vertex_columns.concatenate(Columns(mesh.vertex_columns), count, count);
  mesh.face_columns = mesh.face_columns.select(rows);
}

[[noreturn]] void throw_too_deep() {
  throw GoalError("no point lies that deep inside the surface");
}

/// Returns the border edges of a mesh as triangles without area.
Mesh border_of(const Mesh& mesh) {
  const std::vector<Index> opposites = opposite_halfedges(mesh);
  Mesh border;
  border.positions = mesh.positions;
  for (Index h = 0; h < opposites.size(); ++h)
    if (opposites[h] == no_index)
      border.faces.push_back(
          {halfedge_source(mesh, h), halfedge_target(mesh, h), halfedge_target(mesh, h)});
  return border;
}

/// Distances of points from the source surface and from its border.
class SourceDistance {
 public:
  explicit SourceDistance(const Mesh& source) : query_(source), border_(border_of(source)) {
    if (!border_.faces.empty()) to_border_.emplace(border_);
  }

  double operator()(const Vec3& point) const { return query_(point).distance; }
  bool is_near_border(const Vec3& point, double reach) const {
    return to_border_ && to_border_->face_within(point, reach) != no_index;
  }

 private:
  ClosestPointQuery query_;
  Mesh border_;
  std::optional<ClosestPointQuery> to_border_;
};

/// Removes components whose faces are all closer to the source surface than `least_distance` *
/// distance.
void drop_remains(Mesh& mesh, const SourceDistance& from_source, double distance) {
  const Components parts = connected_components(mesh);
  std::vector<double> farthest(parts.components.size(), 0);
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    double& far = farthest[parts.of_face[f]];
    far = std::max(far, from_source(face_middle(mesh, f)));
  }
  std::vector<bool> keep;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    keep.push_back(farthest[parts.of_face[f]] >= least_distance * distance);
  if (std::ranges::find(keep, true) == keep.end()) throw_too_deep();
  mesh = select_faces(mesh, keep);
}

/// If a part that was turned inside out remains, sets its place. Such a part has points that are
/// too close to the source surface. If planes miss the distance, their points are too close as
/// well, and only this is reported. The walls of a thick sheet reach its surface. Therefore points
/// as near to the border as walls can be are skipped.
void find_remains(const Mesh& mesh, const SourceDistance& from_source, double distance,
                  MiterDeviation& deviation) {
  if (deviation.is_large) return;
  double least = least_distance * distance;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const auto [a, b, c] = triangle_of(mesh, f);
    for (const Vec3& point : {face_middle(mesh, f), a, b, c}) {
      const double near = from_source(point);
      if (near >= least || from_source.is_near_border(point, miter_limit * distance)) continue;
      deviation.remains = point;
      least = near;
    }
  }
}

Mesh cleaned(const Mesh& mesh, Scalar coordinate, const Progress& progress) {
  CleanOptions options;
  options.coordinate = coordinate;
  return clean(mesh, options, progress).mesh;
}

void refuse_bad(const Mesh& mesh, double distance, bool may_be_negative) {
  if (!std::isfinite(distance) || distance == 0 || (distance < 0 && !may_be_negative))
    throw UsageError("the distance must be a length other than 0, and a thickness above 0");
  if (mesh.faces.empty()) throw InputError("the mesh has no faces, so it has no offset");
  const ManifoldReport found = check_manifold(mesh);
  if (!found.is_manifold() || !found.is_oriented())
    throw InputError(ErrorKind::not_manifold, "the mesh is not an oriented manifold");
}

}  // namespace

std::vector<Vec3> miter_directions(const Mesh& mesh) {
  std::vector<Planes> planes(mesh.positions.size());
  for (const Face& face : mesh.faces)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& corner = mesh.positions[face[i]];
      const Vec3 u = (mesh.positions[face[(i + 1) % 3]] - corner).stableNormalized();
      const Vec3 v = (mesh.positions[face[(i + 2) % 3]] - corner).stableNormalized();
      const Vec3 cross = u.cross(v);
      // Weight by the sine of the corner angle instead of the angle. Weights matter only if more
      // than three planes meet.
      const double weight = cross.norm();
      if (!(weight > 0)) continue;
      const Vec3 normal = cross / weight;
      planes[face[i]].matrix += weight * normal * normal.transpose();
      planes[face[i]].right += weight * normal;
    }
  std::vector<Vec3> directions;
  directions.reserve(planes.size());
  for (const Planes& at : planes) directions.push_back(solved(at));
  return directions;
}

MiterDeviation offset_mitered(Mesh& mesh, double distance, Scalar coordinate,
                              const Progress& progress) {
  refuse_bad(mesh, distance, true);
  if (!check_manifold(mesh).is_closed())
    throw InputError(ErrorKind::not_closed,
                     "the mesh is open, but only a closed mesh has an offset");
  const Mesh source = cleaned(mesh, coordinate, progress);
  Mesh moved = source;
  const std::vector<Vec3> directions = miter_directions(source);
  move(moved, directions, distance);
  try {
    moved = cleaned(moved, coordinate, progress);
  } catch (const GoalError& error) {
    // All parts are thinner than the offset, so that they were turned inside out.
    if (distance < 0 && is_nothing_left(error.kind())) throw_too_deep();
    throw;
  }
  MiterDeviation deviation = deviation_of(source, directions, distance);
  const SourceDistance from_source(source);
  drop_remains(moved, from_source, std::abs(distance));
  find_remains(moved, from_source, std::abs(distance), deviation);
  mesh = std::move(moved);
  return deviation;
}

MiterDeviation thicken(Mesh& mesh, double thickness, Scalar coordinate, const Progress& progress) {
  refuse_bad(mesh, thickness, false);
  if (check_manifold(mesh).is_closed())
    throw InputError("the mesh is closed: only a sheet with a border can be thickened");
  Mesh solid = mesh;
  const std::vector<Vec3> directions = miter_directions(mesh);
  MiterDeviation deviation = deviation_of(mesh, directions, thickness / 2);
  move(solid, directions, thickness / 2);
  append_other_side(solid, directions, -thickness);
  solid = cleaned(solid, coordinate, progress);
  find_remains(solid, SourceDistance(mesh), thickness / 2, deviation);
  mesh = std::move(solid);
  refresh_normals(mesh);
  return deviation;
}

}  // namespace transformesh

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "geometry/ray_cast_winding.h"
#include "geometry/search/closest_point.h"
#include "support/elementary/exponential.h"
#include "support/number.h"
#include "support/parallel.h"
#include "transformesh/errors.h"
#include "transformesh/length.h"
#include "transformesh/measure.h"
#include "transformesh/wrap.h"
#include "views/wrap/point_spacing.h"
#include "views/wrap/scale_normalization.h"

namespace transformesh {
namespace {

/// The default of AlphaWrapOptions::offset is the smaller of two lengths: these fractions of the
/// bounding box's diagonal and of the point spacing (point_spacing()). For 50,000 points on a
/// sphere with noise of .5 %, an eighth of the spacing gives a wrap with a Hausdorff distance of
/// .047. The distance is .049 with a fourth of the spacing, and .056 with the fraction of the
/// diagonal.
constexpr double offset_by_diagonal = 1.0 / 300;
constexpr double offset_by_spacing = 1.0 / 8;

/// Range in which alpha is searched, as fractions of the bounding box's diagonal, and the ratio of
/// consecutive candidates: 2^(-1/4).
constexpr double largest_alpha_by_diagonal = 1.0 / 5;
constexpr double least_alpha_by_diagonal = 1.0 / 100;
constexpr double alpha_ratio = 0.8408964152537145;

/// A wrap has about `faces_by_area` faces per area of alpha^2. A million faces take a minute and a
/// gigabyte. Two upper bounds of the area are used. One is the area of balls around all points,
/// whose radius is the offset. The other is twice the area of a wrap with larger alpha. The factor
/// 2 is needed because a wrap also covers the inner side of the sampled surface if balls of radius
/// alpha pass between the points.
constexpr double faces_by_area = 1.3;
constexpr double most_faces = 2e6;
/// Alpha of the coarse wrap that bounds the area, as a fraction of the wrap's diagonal.
constexpr double coarse_alpha_by_size = 1.0 / 50;

/// A wrap is hollow at a face if it is so thin there that it probably follows both sides of the
/// sampled surface. This happens if a ball of radius alpha passes between the points. The thickness
/// is then hardly more than two offsets plus the noise of the points. The limit of the thickness is
/// `hollow_by_offset` times the offset, or `hollow_by_diagonal` times the bounding box's diagonal
/// if the offset is the default.
constexpr double hollow_by_offset = 4;
constexpr double hollow_by_diagonal = hollow_by_offset * offset_by_diagonal;
/// Largest accepted fraction of a wrap's area that is hollow: thin enough to follow both sides of
/// the sampled surface.
constexpr double most_hollow = 0.05;

using WrapKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<WrapKernel::Point_3>;
using Cloud = std::vector<WrapKernel::Point_3>;

Mesh mesh_of_surface(const Surface& surface) {
  Mesh mesh;
  for (const auto vertex : surface.vertices()) {
    const auto& point = surface.point(vertex);
    mesh.positions.emplace_back(point.x(), point.y(), point.z());
  }
  for (const auto face : surface.faces()) {
    Face corners;
    std::size_t i = 0;
    for (const auto vertex : surface.vertices_around_face(surface.halfedge(face)))
      corners[i++] = static_cast<Index>(vertex.idx());
    mesh.faces.push_back(corners);
  }
  return mesh;
}

AlphaWrap wrap(const Cloud& cloud, double alpha, double offset) {
  Surface surface;
  CGAL::alpha_wrap_3(cloud, alpha, offset, surface);
  return {mesh_of_surface(surface), alpha, 0, offset};
}

std::vector<Vec3> distinct_points(const std::vector<Vec3>& points) {
  const std::vector<std::size_t> first = first_equals(points);
  std::vector<Vec3> distinct;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (first[i] == i) distinct.push_back(points[i]);
  return distinct;
}

Cloud cloud_of(const std::vector<Vec3>& points) {
  Cloud cloud;
  for (const Vec3& point : points) cloud.emplace_back(point.x(), point.y(), point.z());
  return cloud;
}

/// Returns the default offset, in the units of `points` and `diagonal`.
double default_offset(const std::vector<Vec3>& points, double diagonal) {
  const double offset = offset_by_diagonal * diagonal;
  if (!(diagonal > 0)) return offset;
  const ScaleNormalization scale(diagonal);
  const double spacing = scale.from_unit(point_spacing(scale.to_unit(points)));
  return spacing > 0 ? std::min(offset, offset_by_spacing * spacing) : offset;
}

double expected_faces(const Cloud& cloud, double alpha, double offset, double diagonal) {
  const double faces_of_unit_area = faces_by_area / (alpha * alpha);
  const double balls = 4 * std::numbers::pi * offset * offset * static_cast<double>(cloud.size());
  const double coarse = coarse_alpha_by_size * (diagonal + 2 * offset);
  if (alpha >= coarse || balls * faces_of_unit_area <= most_faces) return 0;
  return faces_of_unit_area * std::min(balls, 2 * surface_area(wrap(cloud, coarse, offset).mesh));
}

/// Rounds a length up to two digits.
std::string rounded_up(double length) {
  const double power = std::floor(elementary::log10(length)) - 1;
  const double digits = std::ceil(length / elementary::pow(10, power));
  return shortest_text(power < 0 ? digits / elementary::pow(10, -power)
                                 : digits * elementary::pow(10, power));
}

/// Throws UsageError if the wrap with this alpha would have more than `most_faces` faces.
void check_cost(const Cloud& cloud, double alpha, double offset, double diagonal,
                const ScaleNormalization& scale) {
  const double faces = expected_faces(cloud, alpha, offset, diagonal);
  if (faces <= most_faces) return;
  const double least = scale.from_unit(alpha * std::sqrt(faces / most_faces));
  throw UsageError(
      "alpha is too small: the wrap would have more than two million faces and take minutes; use " +
      rounded_up(least) + " or more");
}

/// Returns the smallest distance of a point of `cloud` from the surface of `mesh`.
double least_distance(const Mesh& mesh, const Cloud& cloud) {
  const ClosestPointQuery closest(mesh);
  std::vector<double> distances(cloud.size());
  constexpr std::size_t points_per_task = 512;  // points per parallel task; affects time only
  parallel_for(cloud.size(), points_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      distances[i] = closest(Vec3(cloud[i].x(), cloud[i].y(), cloud[i].z())).distance;
  });
  return *std::ranges::min_element(distances);
}

/// Returns the area of faces behind which the wrap is thinner than `thickness`, as a fraction of
/// the whole area.
double hollow_share(const Mesh& mesh, double thickness) {
  const RayCastWinding winding(mesh);
  double hollow = 0;
  double all = 0;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const auto& [a, b, c] = mesh.faces[f];
    const Vec3 center = (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3;
    const double area = face_area(mesh, f);
    all += area;
    if (winding(center - thickness * face_normal(mesh, f).normalized()) == 0) hollow += area;
  }
  return all > 0 ? hollow / all : 0;
}

/// Computes wraps with decreasing alpha until the hollow fraction of the area exceeds
/// `most_hollow`. Returns the last wrap before that.
AlphaWrap tightest_wrap(const Cloud& cloud, double diagonal, double offset, double thickness) {
  double alpha = largest_alpha_by_diagonal * diagonal;
  AlphaWrap best = wrap(cloud, alpha, offset);
  while ((alpha *= alpha_ratio) >= least_alpha_by_diagonal * diagonal) {
    AlphaWrap next = wrap(cloud, alpha, offset);
    if (hollow_share(next.mesh, thickness) > most_hollow) break;
    best = std::move(next);
  }
  return best;
}

}  // namespace

AlphaWrap alpha_wrap(std::span<const Vec3> points, const AlphaWrapOptions& options) {
  if (!(options.alpha >= 0 && options.offset >= 0))
    throw UsageError("alpha and the offset of a wrap must not be negative");
  if (points.empty()) throw InputError("there are no points to wrap");
  const double diagonal = diagonal_of(points);
  const std::vector<Vec3> distinct = distinct_points({points.begin(), points.end()});
  const bool is_default = options.offset == 0;
  const double offset = is_default ? default_offset(distinct, diagonal) : options.offset;
  if (!(offset > 0 && (options.alpha > 0 || diagonal > 0)))
    throw InputError("the points are all in one place: give alpha and the offset as lengths");
  const double finest = options.alpha > 0 ? std::min(options.alpha, offset) : offset;
  const double largest = std::max({diagonal, options.alpha, offset});
  const ScaleNormalization scale(largest);
  check_detail(points, finest, largest);

  const Cloud cloud = cloud_of(scale.to_unit(distinct));
  const double unit_offset = scale.to_unit(offset);
  if (options.alpha > 0)
    check_cost(cloud, scale.to_unit(options.alpha), unit_offset, scale.to_unit(diagonal), scale);
  const double unit_diagonal = scale.to_unit(diagonal);
  const double thickness =
      is_default ? hollow_by_diagonal * unit_diagonal : hollow_by_offset * unit_offset;
  AlphaWrap result = options.alpha > 0
                         ? wrap(cloud, scale.to_unit(options.alpha), unit_offset)
                         : tightest_wrap(cloud, unit_diagonal, unit_offset, thickness);
  check_wrap(result.mesh);
  result.least_distance = scale.from_unit(least_distance(result.mesh, cloud));
  scale.from_unit(result.mesh);
  result.alpha = scale.from_unit(result.alpha);
  result.offset = offset;
  return result;
}

}  // namespace transformesh

#include "clean/certify/rounding_zone.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/search/closest_point.h"
#include "mesh/coordinate_spacing.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

/// Least margin along an axis, relative to the largest margin along an axis. A limit is needed
/// because numbers near zero have a tiny spacing. For doubles, the margins along all axes are
/// equal. The reason is that distances are computed in doubles, which are too coarse for a
/// different unit of length along each axis.
constexpr double least_share(Scalar coordinate) {
  return coordinate == Scalar::float32 ? 0x1p-20 : 1;
}

/// Error of a measured distance from a triangle, relative to the size of the triangle.
constexpr double measuring_error = 8 * std::numeric_limits<double>::epsilon();

Vec3 spacings_at(const Vec3& point, Scalar coordinate) {
  return point.unaryExpr([=](double x) { return x == 0 ? 0 : spacing_at(x, coordinate); });
}

/// True if no plane perpendicular to `direction` separates the triangle from the cube with |x|, |y|
/// and |z| <= `half`.
bool overlap_along(const Vec3& direction, const Triangle& t, double half) {
  const std::array<double, 3> at = {direction.dot(t[0]), direction.dot(t[1]), direction.dot(t[2])};
  const auto [least, most] = std::minmax_element(at.begin(), at.end());
  const double reach = half * direction.lpNorm<1>();
  return *least <= reach && *most >= -reach;
}

/// True if the triangle meets the cube with |x|, |y| and |z| <= `half`, by the separating axis
/// test. Reference: Akenine-Moller, "Fast 3D triangle-box overlap testing", Journal of Graphics
/// Tools 6(1), 2001.
bool meets_cube(const Triangle& t, double half) {
  const std::array<Vec3, 3> edges = {t[1] - t[0], t[2] - t[1], t[0] - t[2]};
  if (!overlap_along(edges[0].cross(edges[1]), t, half)) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 unit = Vec3::Unit(axis);
    if (!overlap_along(unit, t, half)) return false;
    for (const Vec3& edge : edges)
      if (!overlap_along(unit.cross(edge), t, half)) return false;
  }
  return true;
}

/// Returns a box that contains all points for which `is_within` may be true.
FloatBox box_around(const Triangle& t, const Vec3& margins) {
  const Vec3 low = t[0].cwiseMin(t[1]).cwiseMin(t[2]);
  const Vec3 high = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
  const double size = (high - low).cwiseQuotient(margins).maxCoeff();
  const Vec3 reach = (2 + measuring_error * (size + 4)) * margins;
  return float_box(low - reach, high + reach);
}

/// Returns the least margin along each axis: twice the spacing of numbers at the triangle.
Vec3 least_margins(const Triangle& t, Scalar coordinate) {
  const Vec3 size = t[0].cwiseAbs().cwiseMax(t[1].cwiseAbs()).cwiseMax(t[2].cwiseAbs());
  const Vec3 spacings = spacings_at(size, coordinate);
  return 2 * spacings.cwiseMax(least_share(coordinate) * spacings.maxCoeff());
}

Vec3 shift_from(const ClosestPointQuery& surface, const Vec3& point) {
  return (surface(point).point - point).cwiseAbs();
}

/// Returns for each vertex of the faces the distance, along each axis, from its closest point on
/// the surface. Other vertices get zero.
std::vector<Vec3> vertex_shifts(const ClosestPointQuery& surface, const Mesh& mesh,
                                const std::vector<Index>& faces) {
  std::vector<char> is_used(mesh.positions.size(), 0);
  for (const Index face : faces)
    for (const Index v : mesh.faces[face]) is_used[v] = 1;
  std::vector<Vec3> shifts(mesh.positions.size(), Vec3::Zero());
  parallel_for(shifts.size(), 64, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v)
      if (is_used[v]) shifts[v] = shift_from(surface, mesh.positions[v]);
  });
  return shifts;
}

}  // namespace

std::vector<Vec3> rounding_margins(const Mesh& input, const Mesh& output,
                                   const std::vector<Index>& faces, Scalar coordinate) {
  const ClosestPointQuery surface(input);
  const std::vector<Vec3> shifts = vertex_shifts(surface, output, faces);
  std::vector<Vec3> margins(faces.size());
  parallel_for(faces.size(), 64, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const Triangle t = triangle_of(output, faces[i]);
      Vec3 shift = shift_from(surface, (t[0] + t[1] + t[2]) / 3);
      for (std::size_t k = 0; k < 3; ++k)
        shift = shift.cwiseMax(shifts[output.faces[faces[i]][k]])
                    .cwiseMax(shift_from(surface, (t[k] + t[(k + 1) % 3]) / 2));
      const Vec3 least = least_margins(t, coordinate);
      margins[i] = (4 * shift).cwiseMin(512 * least.maxCoeff()).cwiseMax(least);
    }
  });
  return margins;
}

bool is_within(const Vec3& margins, const Vec3& point, const Triangle& triangle) {
  Triangle measured;
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    measured[i] = (triangle[i] - point).cwiseQuotient(margins);
    size = std::max(size, measured[i].cwiseAbs().maxCoeff());
  }
  return meets_cube(measured, 1 + measuring_error * size);
}

RoundingZone::RoundingZone(const Mesh& input, const Mesh& output, const FaceMatch& match,
                           Scalar coordinate) {
  const auto add = [&](const Triangle& triangle, const Vec3& margins) {
    if (margins.isZero(0)) return;  // a face whose three corners are (0, 0, 0)
    triangles_.push_back(triangle);
    margins_.push_back(margins);
  };
  const std::vector<Index> new_faces = marked_faces(match.output_is_new, 1);
  const std::vector<Vec3> margins = rounding_margins(input, output, new_faces, coordinate);
  for (std::size_t i = 0; i < new_faces.size(); ++i)
    add(triangle_of(output, new_faces[i]), margins[i]);
  for (const Index face : marked_faces(match.input_vanished, 1)) {
    const Triangle triangle = triangle_of(input, face);
    add(triangle, least_margins(triangle, coordinate));
  }

  std::vector<FloatBox> boxes;
  for (std::size_t i = 0; i < triangles_.size(); ++i)
    boxes.push_back(box_around(triangles_[i], margins_[i]));
  bvh_ = Bvh(boxes);
}

bool RoundingZone::contains(const Vec3& point) const {
  bool is_near = false;
  bvh_.visit_overlaps(float_box(point, point), [&](Index i) {
    is_near = is_within(margins_[i], point, triangles_[i]);
    return !is_near;
  });
  return is_near;
}

Vec3 RoundingZone::margins_at(const Vec3& point) const {
  Vec3 margins = 4 * spacings_at(point, Scalar::float64);
  bvh_.visit_overlaps(float_box(point, point), [&](Index i) {
    margins = margins.cwiseMax(margins_[i]);
    return true;
  });
  return margins;
}

double RoundingZone::largest_margin() const {
  double largest = 0;
  for (const Vec3& margins : margins_) largest = std::max(largest, margins.maxCoeff());
  return largest;
}

}  // namespace transformesh

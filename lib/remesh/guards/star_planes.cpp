#include "remesh/guards/star_planes.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace transformesh {
namespace {

/// Directions are separated from a triangle if their distance from the plane, on the unit sphere,
/// exceeds this. May_touch() counts gaps below 1e-9 as contact, which must not be missed.
constexpr double least_gap = 1e-8;
/// Planes are only used if the sine of the angle between the vectors that span them exceeds this.
/// The rounding error of the plane's normal is then below a hundredth of `least_gap`.
constexpr double least_sine = 1e-6;

/// True if the point is in the bounding box of the triangle, or near it.
bool is_near(const Vec3& point, const Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  const Vec3 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
  const double margin = least_gap * (point - a).norm();
  return (point.array() >= low.array() - margin).all() &&
         (point.array() <= high.array() + margin).all();
}

}  // namespace

StarPlanes::StarPlanes(const Vec3& vertex, const Triangle& triangle) {
  Triangle directions;
  std::transform(triangle.begin(), triangle.end(), directions.begin(),
                 [&](const Vec3& corner) { return (corner - vertex).stableNormalized(); });
  const auto corner = std::find(triangle.begin(), triangle.end(), vertex) - triangle.begin();
  if (corner < 3) {
    add_at_corner(directions[(corner + 1) % 3], directions[(corner + 2) % 3]);
  } else if (!is_near(vertex, triangle)) {
    add_at_edges(directions);
  }
}

void StarPlanes::add(const Vec3& normal) {
  const double length = normal.norm();
  if (length > least_sine) normals_[count_++] = normal / length;
}

/// Adds the plane of a triangle in both orientations, and the planes perpendicular to it along its
/// edges at the vertex.
void StarPlanes::add_at_corner(const Vec3& first, const Vec3& second) {
  const Vec3 normal = first.cross(second);
  add(normal);
  add(-normal);
  add(first.dot(second) * first - second);
  add(first.dot(second) * second - first);
}

/// Adds the planes through the edges of a triangle that does not have the vertex as a corner.
void StarPlanes::add_at_edges(const Triangle& directions) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 normal = directions[i].cross(directions[(i + 1) % 3]);
    add(normal.dot(directions[(i + 2) % 3]) > 0 ? Vec3(-normal) : normal);
  }
}

bool StarPlanes::separate(const FloatBox& directions) const {
  const Vec3 low = directions.min().cast<double>(), high = directions.max().cast<double>();
  return std::any_of(normals_.begin(), normals_.begin() + static_cast<std::ptrdiff_t>(count_),
                     [&](const Vec3& normal) {
                       return normal.cwiseMax(0).dot(low) + normal.cwiseMin(0).dot(high) >
                              least_gap;
                     });
}

}  // namespace transformesh

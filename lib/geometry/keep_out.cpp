#include "geometry/keep_out.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/numbers/predicates.h"
#include "geometry/search/closest_point.h"
#include "geometry/solid_angle_winding.h"
#include "mesh/location_text.h"
#include "support/parallel.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

constexpr std::size_t faces_per_task = 256;  ///< affects time only
/// A winding number counts as 0 if its absolute value and its error bound are below this.
constexpr double undecided = 0.25;
/// Bound of the rounding error of distances, relative to coordinates.
constexpr double rounding = 1e-14;

void extend(Box& box, std::span<const Triangle> triangles) {
  for (const Triangle& triangle : triangles)
    for (const Vec3& corner : triangle) box.extend(corner);
}

FloatBox widened(const Box& box, double by) {
  return float_box(box.min() - Vec3::Constant(by), box.max() + Vec3::Constant(by));
}

/// True if the segment intersects the triangle; exact. False if the segment is in the plane of the
/// triangle.
bool pierces(const Vec3& from, const Vec3& to, const Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  const int side_from = orient3d(a, b, c, from);
  const int side_to = orient3d(a, b, c, to);
  if (side_from * side_to > 0 || (side_from == 0 && side_to == 0)) return false;
  const int first = orient3d(from, to, a, b);
  const int second = orient3d(from, to, b, c);
  const int third = orient3d(from, to, c, a);
  return first * second >= 0 && second * third >= 0 && third * first >= 0;
}

/// True if the triangle is on one side of a plane, at least at the given distance from it. The
/// plane contains `point` and has the unit normal `normal`.
bool is_beyond(const Triangle& triangle, const Vec3& point, const Vec3& normal, double distance) {
  const double a = normal.dot(triangle[0] - point);
  const double b = normal.dot(triangle[1] - point);
  const double c = normal.dot(triangle[2] - point);
  return std::min({a, b, c}) >= distance || std::max({a, b, c}) <= -distance;
}

Vec3 normal_to_keep(const Triangle& triangle) {
  return normal_of(triangle[0], triangle[1], triangle[2]).stableNormalized();
}

/// Returns the squared distance of two segments. For nearly parallel segments the result may be too
/// large. In this case the distance of an end of one segment from the other segment is the least
/// distance. Reference: Ericson, "Real-time collision detection", 2005, 5.1.9.
double squared_segment_distance(const Vec3& p, const Vec3& p_end, const Vec3& q,
                                const Vec3& q_end) {
  const Vec3 d = p_end - p;
  const Vec3 e = q_end - q;
  const Vec3 r = p - q;
  const double dd = d.squaredNorm();
  const double ee = e.squaredNorm();
  if (dd == 0 || ee == 0) return HUGE_VAL;  // the caller measures distances from ends
  const double de = d.dot(e);
  const double dr = d.dot(r);
  const double er = e.dot(r);
  const double across = dd * ee - de * de;
  double s = across > 0 ? std::clamp((de * er - dr * ee) / across, 0.0, 1.0) : 0;
  const double t = std::clamp((de * s + er) / ee, 0.0, 1.0);
  s = std::clamp((de * t - dr) / dd, 0.0, 1.0);
  return (p + s * d - q - t * e).squaredNorm();
}

double squared_corner_distance(const Triangle& corners, const Triangle& triangle) {
  double least = HUGE_VAL;
  for (const Vec3& corner : corners) {
    const Vec3 nearest =
        closest_point_of_triangle(corner, triangle[0], triangle[1], triangle[2]).point;
    least = std::min(least, (nearest - corner).squaredNorm());
  }
  return least;
}

bool edges_pierce(const Triangle& edges, const Triangle& triangle) {
  return pierces(edges[0], edges[1], triangle) || pierces(edges[1], edges[2], triangle) ||
         pierces(edges[2], edges[0], triangle);
}

void add_to(Mesh& mesh, std::span<const Triangle> triangles, bool reversed) {
  for (const Triangle& triangle : triangles) {
    const auto first = static_cast<Index>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), triangle.begin(), triangle.end());
    if (reversed) std::swap(mesh.positions[first + 1], mesh.positions[first + 2]);
    mesh.faces.push_back({first, first + 1, first + 2});
  }
}

}  // namespace

double distance_of(const Triangle& first, const Triangle& second) {
  if (edges_pierce(first, second) || edges_pierce(second, first)) return 0;
  double least =
      std::min(squared_corner_distance(first, second), squared_corner_distance(second, first));
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      least = std::min(least, squared_segment_distance(first[i], first[(i + 1) % 3], second[j],
                                                       second[(j + 1) % 3]));
  return std::sqrt(least);
}

KeepOut::KeepOut(const KeepOutOptions& options)
    : surface_(options.surface), gap_(options.gap), bvh_(*options.surface) {
  if (!(std::isfinite(gap_) && gap_ > 0))
    throw UsageError("the gap to the surface that the mesh must keep away from must be above 0");
  normals_.reserve(surface_->faces.size());
  for (Index f = 0; f < surface_->faces.size(); ++f)
    normals_.push_back(normal_to_keep(triangle_of(*surface_, f)));
}

double KeepOut::distance(const Triangle& triangle, double bound) const {
  Box box;
  extend(box, {&triangle, 1});
  double least = bound;
  const Vec3 normal = normal_to_keep(triangle);
  bvh_.visit_overlaps(widened(box, bound), [&](Index face) {
    if (!is_apart(triangle, normal, face, least))
      least = std::min(least, distance_of(triangle, triangle_of(*surface_, face)));
    return least > 0;
  });
  return least;
}

std::vector<Index> KeepOut::faces_near(Triangles made, Triangles replaced, Triangles sides) const {
  Box box;
  for (const Triangles part : {made, replaced, sides}) extend(box, part);
  std::vector<Index> faces;
  bvh_.visit_overlaps(widened(box, gap_), [&](Index face) {
    faces.push_back(face);
    return true;
  });
  return faces;
}

bool KeepOut::is_apart(const Triangle& triangle, const Vec3& normal, Index face,
                       double distance) const {
  const Triangle other = triangle_of(*surface_, face);
  const double margin = rounding * (triangle[0].cwiseAbs().maxCoeff() + distance);
  return is_beyond(triangle, other[0], normals_[face], distance + margin) ||
         is_beyond(other, triangle[0], normal, distance + margin);
}

double KeepOut::least_distance(Triangles triangles, const std::vector<Index>& faces,
                               double enough) const {
  double least = enough;
  for (const Triangle& triangle : triangles) {
    const Vec3 normal = normal_to_keep(triangle);
    for (const Index face : faces)
      if (!is_apart(triangle, normal, face, least))
        least = std::min(least, distance_of(triangle, triangle_of(*surface_, face)));
  }
  return least;
}

bool KeepOut::meets(Triangles sides, const std::vector<Index>& faces) const {
  return !sides.empty() && !(least_distance(sides, faces, gap_) > 0);
}

/// True if a face of the surface is inside the volume between the triangles `made` and `replaced`,
/// which `sides` close. The face must not intersect them.
bool KeepOut::is_between(Triangles made, Triangles replaced, Triangles sides, Index face) const {
  Mesh around;
  add_to(around, made, false);
  add_to(around, sides, false);
  add_to(around, replaced, true);
  const BoundedWindingNumber winding =
      SolidAngleWinding(around)(surface_->positions[surface_->faces[face][0]]);
  return !(winding.error < undecided && std::abs(winding.number) < undecided);
}

bool KeepOut::allows(Triangles made, Triangles replaced, Triangles sides) const {
  const std::vector<Index> faces = faces_near(made, replaced, sides);
  if (faces.empty()) return true;
  const double distance = least_distance(made, faces, gap_);
  if (distance < gap_ && !(distance > 0 && distance >= least_distance(replaced, faces, gap_)))
    return false;
  if (meets(sides, faces)) return false;

  // Bounding box of the volume. Faces inside the volume have all corners in it.
  Box box;
  for (const Triangles part : {made, replaced, sides}) extend(box, part);
  return std::ranges::none_of(faces, [&](Index face) {
    const Triangle corners = triangle_of(*surface_, face);
    return box.contains(corners[0]) && box.contains(corners[1]) && box.contains(corners[2]) &&
           is_between(made, replaced, sides, face);
  });
}

std::size_t KeepOut::count_near(const Mesh& mesh) const {
  std::vector<double> distances(mesh.faces.size());
  parallel_for(distances.size(), faces_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f)
      distances[f] = distance(triangle_of(mesh, static_cast<Index>(f)), gap_);
  });
  const auto met = std::ranges::find(distances, 0.0);
  if (met != distances.end()) {
    const auto face = static_cast<std::size_t>(met - distances.begin());
    const Vec3& place = mesh.positions[mesh.faces[face][0]];
    throw InputError(ErrorKind::meets_keep_out,
                     "face " + std::to_string(face) + " at " + point_text(place) +
                         " intersects the surface that the mesh must keep away from",
                     {.faces = {face}, .position = position_data(place)});
  }
  return static_cast<std::size_t>(
      std::ranges::count_if(distances, [&](double distance) { return distance < gap_; }));
}

}  // namespace transformesh

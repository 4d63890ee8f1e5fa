#include "tm/clean/rounding_zone.h"

#include <algorithm>
#include <cmath>

#include "tm/geometry/closest_point.h"
#include "tm/mesh/measure.h"
#include "tm/support/parallel.h"

namespace transformesh {
namespace {

constexpr int double_digits = 53;
/// The spacing of numbers near zero is none: margins are at least this share of the largest.
constexpr double smallest_margin = 0x1p-30;

Triangle corners(const Mesh& mesh, Index face) {
  const auto& [a, b, c] = mesh.faces[face];
  return {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
}

double spacing_at(double coordinate, int digits) {
  if (coordinate == 0) return 0;
  return std::ldexp(1.0, std::ilogb(coordinate) + 1 - digits);
}

Vec3 spacings_at(const Vec3& point, int digits) {
  return point.unaryExpr([=](double x) { return spacing_at(std::abs(x), digits); });
}

int digits_of(Scalar coordinate) { return coordinate == Scalar::float32 ? 24 : double_digits; }

double largest_coordinate(const Mesh& mesh) {
  const Box box = bounding_box(mesh);
  return box.minimum.cwiseAbs().cwiseMax(box.maximum.cwiseAbs()).maxCoeff();
}

FloatBox box_around(const Triangle& t, const Vec3& margins) {
  return float_box(t[0].cwiseMin(t[1]).cwiseMin(t[2]) - margins,
                   t[0].cwiseMax(t[1]).cwiseMax(t[2]) + margins);
}

/// Twice the spacing of numbers at the triangle.
Vec3 least_margins(const Triangle& t, int digits, double spacing) {
  const Vec3 size = t[0].cwiseAbs().cwiseMax(t[1].cwiseAbs()).cwiseMax(t[2].cwiseAbs());
  return (2 * spacings_at(size, digits)).cwiseMax(smallest_margin * spacing);
}

Vec3 shift_from(const ClosestPointQuery& surface, const Vec3& point) {
  return (surface(point).point - point).cwiseAbs();
}

/// How far each vertex of the faces is off the surface, along each axis; zero for the others.
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
  const int digits = digits_of(coordinate);
  const double spacing = spacing_at(largest_coordinate(output), digits);
  std::vector<Vec3> margins(faces.size());
  parallel_for(faces.size(), 64, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const Triangle t = corners(output, faces[i]);
      Vec3 shift = shift_from(surface, (t[0] + t[1] + t[2]) / 3);
      for (const Index v : output.faces[faces[i]]) shift = shift.cwiseMax(shifts[v]);
      margins[i] = (4 * shift).cwiseMin(1024 * spacing).cwiseMax(least_margins(t, digits, spacing));
    }
  });
  return margins;
}

bool is_within(const Vec3& margins, const Vec3& point, const Triangle& triangle) {
  // With the margins as units their box fits into a ball.
  const auto measured = [&](const Vec3& p) { return Vec3((p - point).cwiseQuotient(margins)); };
  return closest_point_of_triangle(Vec3::Zero(), measured(triangle[0]), measured(triangle[1]),
                                   measured(triangle[2]))
             .point.squaredNorm() <= 3;
}

RoundingZone::RoundingZone(const Mesh& input, const Mesh& output, const FaceMatch& match,
                           Scalar coordinate) {
  const std::vector<Index> new_faces = marked_faces(match.output_is_new, 1);
  margins_ = rounding_margins(input, output, new_faces, coordinate);
  for (const Index face : new_faces) triangles_.push_back(corners(output, face));

  const int digits = digits_of(coordinate);
  const double spacing = spacing_at(largest_coordinate(output), digits);
  for (const Index face : marked_faces(match.input_vanished, 1)) {
    triangles_.push_back(corners(input, face));
    margins_.push_back(least_margins(triangles_.back(), digits, spacing));
  }

  std::vector<FloatBox> boxes;
  for (std::size_t i = 0; i < triangles_.size(); ++i)
    boxes.push_back(box_around(triangles_[i], 2 * margins_[i]));
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
  Vec3 margins = 4 * spacings_at(point, double_digits);
  bvh_.visit_overlaps(float_box(point, point), [&](Index i) {
    margins = margins.cwiseMax(margins_[i]);
    return true;
  });
  return margins;
}

}  // namespace transformesh

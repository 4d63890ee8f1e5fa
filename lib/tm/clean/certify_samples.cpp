#include "tm/clean/certify_samples.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "tm/geometry/closest_point.h"
#include "tm/mesh/measure.h"
#include "tm/support/parallel.h"

namespace transformesh {
namespace {

/// Points of a face that are tried, by the weights of its corners.
constexpr std::array<std::array<double, 3>, 5> tried_weights = {{{0.344, 0.327, 0.329},
                                                                 {0.523, 0.218, 0.259},
                                                                 {0.231, 0.552, 0.217},
                                                                 {0.262, 0.193, 0.545},
                                                                 {0.101, 0.468, 0.431}}};

/// How much nearer the next sample is tried where something was in the way.
constexpr double step = 2;

/// Samples are no nearer than this share of the least height of their face.
constexpr double nearest_share = 0x1p-60;

constexpr int double_digits = 53;
/// The spacing of numbers near zero is none: margins are at least this share of the largest.
constexpr double smallest_margin = 0x1p-30;

Triangle corners(const Mesh& mesh, Index face) {
  const auto& [a, b, c] = mesh.faces[face];
  return {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
}

struct Plane {
  Vec3 normal = Vec3::Zero();
  double height = 0;  ///< the least of the triangle
};

/// Without overflow or underflow whatever the size of the triangle.
Plane plane(const Triangle& t) {
  const std::array<Vec3, 3> edges = {t[1] - t[0], t[2] - t[1], t[0] - t[2]};
  double longest = 0;
  for (const Vec3& edge : edges) longest = std::max(longest, edge.stableNorm());
  if (longest == 0) return {};
  const Vec3 cross = (edges[0] / longest).cross(edges[1] / longest);
  return {cross.stableNormalized(), cross.stableNorm() * longest};
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

/// Along each axis the most that one of seven points of the triangle is off the surface.
Vec3 shift_from(const ClosestPointQuery& surface, const Triangle& t) {
  Vec3 shift = Vec3::Zero();
  for (const Vec3& point : {t[0], t[1], t[2], Vec3((t[0] + t[1]) / 2), Vec3((t[1] + t[2]) / 2),
                            Vec3((t[2] + t[0]) / 2), Vec3((t[0] + t[1] + t[2]) / 3)})
    shift = shift.cwiseMax((surface(point).point - point).cwiseAbs());
  return shift;
}

}  // namespace

std::vector<Vec3> rounding_margins(const Mesh& input, const Mesh& output,
                                   const std::vector<Index>& faces, Scalar coordinate) {
  const ClosestPointQuery closest(input);
  const int digits = digits_of(coordinate);
  const double spacing = spacing_at(largest_coordinate(output), digits);
  std::vector<Vec3> margins(faces.size());
  parallel_for(faces.size(), 64, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const Triangle t = corners(output, faces[i]);
      const Vec3 size = t[0].cwiseAbs().cwiseMax(t[1].cwiseAbs()).cwiseMax(t[2].cwiseAbs());
      const Vec3 least = (2 * spacings_at(size, digits)).cwiseMax(smallest_margin * spacing);
      margins[i] = (4 * shift_from(closest, t)).cwiseMin(1024 * spacing).cwiseMax(least);
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

SampleFinder::SampleFinder(const Mesh& input, const Mesh& output, const FaceMatch& match,
                           Scalar coordinate)
    : input_winding_(input),
      output_winding_(output),
      output_(&output),
      new_faces_(marked_faces(match.output_is_new, 1)),
      margins_(rounding_margins(input, output, new_faces_, coordinate)) {
  std::vector<FloatBox> boxes;
  for (std::size_t i = 0; i < new_faces_.size(); ++i)
    boxes.push_back(box_around(corners(output, new_faces_[i]), 2 * margins_[i]));
  new_bvh_ = Bvh(boxes);
}

/// How far the surface of the output may be misplaced at a point of it, and the point itself.
Vec3 SampleFinder::margins_at(const Vec3& point) const {
  Vec3 margins = 4 * spacings_at(point, double_digits);
  new_bvh_.visit_overlaps(float_box(point, point), [&](Index i) {
    margins = margins.cwiseMax(margins_[i]);
    return true;
  });
  return margins;
}

bool SampleFinder::may_be_misplaced(const Vec3& point) const {
  bool is_near = false;
  new_bvh_.visit_overlaps(float_box(point, point), [&](Index i) {
    is_near = is_within(margins_[i], point, corners(*output_, new_faces_[i]));
    return !is_near;
  });
  return is_near;
}

std::optional<WindingSample> SampleFinder::find_above(const Vec3& base, const Vec3& direction,
                                                      double height) const {
  // From where on the segment is beside the face, whatever rounding did to face and point.
  const double clearance =
      std::max(direction.cwiseAbs().dot(margins_at(base)), nearest_share * height);
  const Vec3 start = base + clearance * direction;
  for (double distance = std::max(height / 4, 4 * clearance);
       distance >= 2 * clearance && distance > 0; distance /= step) {
    const Vec3 point = base + distance * direction;
    if (input_winding_.blocks(start, point) || output_winding_.blocks(start, point)) continue;
    if (may_be_misplaced(point)) continue;
    const std::optional<int> in = input_winding_(point);
    const std::optional<int> out = output_winding_(point);
    if (in && out) return WindingSample{point, *in, *out};
  }
  return std::nullopt;
}

std::optional<WindingSample> SampleFinder::find(const Mesh& mesh, Index face, int side) const {
  const Triangle t = corners(mesh, face);
  const auto [normal, height] = plane(t);
  if (!(height > 0)) return std::nullopt;
  for (const auto& weights : tried_weights) {
    const Vec3 base = weights[0] * t[0] + weights[1] * t[1] + weights[2] * t[2];
    std::optional<WindingSample> sample = find_above(base, side * normal, height);
    if (sample) return sample;
  }
  return std::nullopt;
}

}  // namespace transformesh

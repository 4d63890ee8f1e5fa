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
constexpr double step = 8;

struct Corners {
  Vec3 a, b, c;
  double size() const {
    return std::max({a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff(), c.cwiseAbs().maxCoeff()});
  }
};

Corners corners(const Mesh& mesh, Index face) {
  const auto& [a, b, c] = mesh.faces[face];
  return {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
}

struct Plane {
  Vec3 normal = Vec3::Zero();
  double height = 0;  ///< the least of the triangle
};

/// Without overflow or underflow whatever the size of the triangle.
Plane plane(const Corners& t) {
  const std::array<Vec3, 3> edges = {t.b - t.a, t.c - t.b, t.a - t.c};
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

FloatBox box_around(const Corners& t, double margin) {
  const Vec3 wide = Vec3::Constant(margin);
  return float_box(t.a.cwiseMin(t.b).cwiseMin(t.c) - wide, t.a.cwiseMax(t.b).cwiseMax(t.c) + wide);
}

}  // namespace

double coordinate_spacing(const Mesh& mesh, Scalar coordinate) {
  const Box box = bounding_box(mesh);
  return spacing_at(box.minimum.cwiseAbs().cwiseMax(box.maximum.cwiseAbs()).maxCoeff(),
                    coordinate == Scalar::float32 ? 24 : 53);
}

std::vector<double> rounding_tolerances(const Mesh& input, const Mesh& output,
                                        const std::vector<Index>& faces, double spacing) {
  const ClosestPointQuery closest(input);
  std::vector<double> tolerances(faces.size());
  parallel_for(faces.size(), 64, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const auto& [a, b, c] = corners(output, faces[i]);
      double shift = 0;
      for (const Vec3& point : {a, b, c, Vec3((a + b) / 2), Vec3((b + c) / 2), Vec3((c + a) / 2),
                                Vec3((a + b + c) / 3)})
        shift = std::max(shift, closest(point).distance);
      tolerances[i] = std::clamp(4 * shift, 2 * spacing, 1024 * spacing);
    }
  });
  return tolerances;
}

SampleFinder::SampleFinder(const Mesh& input, const Mesh& output, const FaceMatch& match,
                           double spacing)
    : input_winding_(input),
      output_winding_(output),
      output_(&output),
      new_faces_(marked_faces(match.output_is_new, 1)),
      tolerances_(rounding_tolerances(input, output, new_faces_, spacing)) {
  std::vector<FloatBox> boxes;
  for (std::size_t i = 0; i < new_faces_.size(); ++i)
    boxes.push_back(box_around(corners(output, new_faces_[i]), tolerances_[i]));
  new_bvh_ = Bvh(boxes);
}

/// A bound of how far the surface of the output may be misplaced at a point of it.
double SampleFinder::tolerance_at(const Vec3& point) const {
  double tolerance = 0;
  new_bvh_.visit_overlaps(float_box(point, point), [&](Index i) {
    tolerance = std::max(tolerance, tolerances_[i]);
    return true;
  });
  return tolerance;
}

bool SampleFinder::may_be_misplaced(const Vec3& point) const {
  bool is_near = false;
  new_bvh_.visit_overlaps(float_box(point, point), [&](Index i) {
    const auto& [a, b, c] = corners(*output_, new_faces_[i]);
    const Vec3 closest = closest_point_of_triangle(point, a, b, c).point;
    is_near = (closest - point).stableNorm() <= tolerances_[i];
    return !is_near;
  });
  return is_near;
}

std::optional<WindingSample> SampleFinder::find_above(const Vec3& base, const Vec3& direction,
                                                      double height) const {
  // From where on the segment is beside the face, whatever rounding did to face and point.
  const double clearance =
      std::max(8 * spacing_at(base.cwiseAbs().maxCoeff(), 53), tolerance_at(base));
  const Vec3 start = base + clearance * direction;
  for (double distance = std::max(height / 4, 4 * clearance); distance >= 2 * clearance;
       distance /= step) {
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
  const Corners t = corners(mesh, face);
  const auto [normal, height] = plane(t);
  if (!(height > 0)) return std::nullopt;
  for (const auto& weights : tried_weights) {
    const Vec3 base = weights[0] * t.a + weights[1] * t.b + weights[2] * t.c;
    const std::optional<WindingSample> sample = find_above(base, side * normal, height);
    if (sample) return sample;
  }
  return std::nullopt;
}

}  // namespace transformesh

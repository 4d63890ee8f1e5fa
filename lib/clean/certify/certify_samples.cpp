#include "clean/certify/certify_samples.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace transformesh {
namespace {

/// Barycentric weights of points of a face. Samples above these points are tried, one after the
/// other.
constexpr std::array<std::array<double, 3>, 14> tried_weights = {{{0.344, 0.327, 0.329},
                                                                  {0.523, 0.218, 0.259},
                                                                  {0.231, 0.552, 0.217},
                                                                  {0.262, 0.193, 0.545},
                                                                  {0.101, 0.468, 0.431},
                                                                  {0.442, 0.113, 0.445},
                                                                  {0.457, 0.437, 0.106},
                                                                  {0.763, 0.121, 0.116},
                                                                  {0.118, 0.767, 0.115},
                                                                  {0.123, 0.112, 0.765},
                                                                  {0.618, 0.331, 0.051},
                                                                  {0.324, 0.047, 0.629},
                                                                  {0.053, 0.321, 0.626},
                                                                  {0.052, 0.627, 0.321}}};

/// If a sample above a point of the face is rejected, its distance from the face is divided by this
/// factor for the next sample.
constexpr double step = 2;

/// Least distance of a sample point from its face, relative to the distance by which rounding may
/// have moved the face. A choice: larger values leave more samples undecided.
constexpr double beyond_clearance = 1.25;

/// Least distance of a sample point from its face, relative to the least height of the face.
constexpr double nearest_share = 0x1p-60;

struct Plane {
  Vec3 normal = Vec3::Zero();
  double height = 0;  ///< least height of the triangle
};

/// Returns the plane of a triangle; avoids overflow and underflow for all sizes.
Plane plane(const Triangle& t) {
  const std::array<Vec3, 3> edges = {t[1] - t[0], t[2] - t[1], t[0] - t[2]};
  double longest = 0;
  for (const Vec3& edge : edges) longest = std::max(longest, edge.stableNorm());
  if (longest == 0) return {};
  const Vec3 cross = (edges[0] / longest).cross(edges[1] / longest);
  return {cross.stableNormalized(), cross.stableNorm() * longest};
}

}  // namespace

SampleFinder::SampleFinder(const Mesh& input, const Mesh& output, const FaceMatch& match,
                           Scalar coordinate)
    : input_winding_(input), output_winding_(output), zone_(input, output, match, coordinate) {}

std::optional<WindingSample> SampleFinder::find_above(const Vec3& base, const Vec3& direction,
                                                      double height) const {
  // Points closer than the clearance may be on the other side of the face because of rounding.
  const double clearance =
      std::max(direction.cwiseAbs().dot(zone_.margins_at(base)), nearest_share * height);
  const Vec3 start = base + clearance * direction;
  const double nearest = beyond_clearance * clearance;
  for (double distance = std::max(height / 4, step * step * nearest);
       distance >= nearest && distance > 0; distance /= step) {
    const Vec3 point = base + distance * direction;
    if (input_winding_.blocks(start, point) || output_winding_.blocks(start, point)) continue;
    if (zone_.contains(point)) continue;
    const std::optional<int> in = input_winding_(point);
    const std::optional<int> out = output_winding_(point);
    if (in && out) return WindingSample{point, *in, *out};
  }
  return std::nullopt;
}

std::optional<WindingSample> SampleFinder::find(const Mesh& mesh, Index face, int side) const {
  const Triangle t = triangle_of(mesh, face);
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

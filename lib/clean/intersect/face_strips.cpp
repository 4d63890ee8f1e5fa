#include "clean/intersect/face_strips.h"

#include <algorithm>

#include "support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t strips_per_task = 4096;  ///< affects time only
/// A face is thin, and gets a strip, if its longest edge is at least this multiple of its height.
/// If all faces get strips, cleaning two overlapping spheres and a folded sphere takes a tenth
/// longer.
constexpr double thinness = 8;
/// Twice the rounding error of a dot product of two 3D vectors, relative to the sum of the absolute
/// values of its three products. The dot product of a point and the bound of the strip each have an
/// error of 3 units of 2^-53.
constexpr double dot_error = 0x1p-50;

Vec3 largest_coordinates(std::span<const Vec3> points) {
  Vec3 largest = Vec3::Zero();
  for (const Vec3& point : points) largest = largest.cwiseMax(point.cwiseAbs());
  return largest;
}

Vec3 longest_edge(const Triangle& t) {
  const Vec3 a = t[1] - t[0], b = t[2] - t[1], c = t[0] - t[2];
  const Vec3& longer = a.squaredNorm() < b.squaredNorm() ? b : a;
  return longer.squaredNorm() < c.squaredNorm() ? c : longer;
}

Vec3 twice_area(const Triangle& t) { return (t[1] - t[0]).cross(t[2] - t[0]); }

// True if the triangle is so long and thin that it gets a strip. The fourth power of a length
// overflows above 1e77, and underflows below 1e-81. Triangles with longest edges of such lengths do
// not count as thin, so that their strips need not be computed.
bool is_thin(const Triangle& t) {
  const double length = longest_edge(t).squaredNorm();
  return length * length > thinness * thinness * twice_area(t).squaredNorm();
}

}  // namespace

// Returns the strip of a triangle. Its direction is perpendicular to the longest edge and to the
// normal, up to rounding. Rounding affects only the efficiency: any direction gives a valid strip.
FaceStrips::Strip FaceStrips::strip_of(const Triangle& t, const Vec3& largest) {
  const Vec3 direction = longest_edge(t).cross(twice_area(t)).stableNormalized();
  const double a = direction.dot(t[0]), b = direction.dot(t[1]), c = direction.dot(t[2]);
  const double error = dot_error * direction.cwiseAbs().dot(largest);
  return {direction, std::min({a, b, c}) - error, std::max({a, b, c}) + error};
}

FaceStrips::FaceStrips(const WeldedMesh& welded, std::span<const Index> faces)
    : welded_(welded), faces_(faces), place_of_(faces.size()) {
  parallel_for(faces.size(), strips_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      place_of_[i] = is_thin(welded.triangle(faces[i])) ? 0 : no_index;
  });
  std::vector<Index> thin;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (place_of_[i] == no_index) continue;
    place_of_[i] = static_cast<Index>(thin.size());
    thin.push_back(faces[i]);
  }
  if (thin.empty()) return;
  const Vec3 largest = largest_coordinates(welded.points);
  strips_.resize(thin.size());
  parallel_for(thin.size(), strips_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      strips_[i] = strip_of(welded.triangle(thin[i]), largest);
  });
}

}  // namespace transformesh

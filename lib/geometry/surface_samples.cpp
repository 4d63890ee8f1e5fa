#include "geometry/surface_samples.h"

#include <cmath>

#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// Returns a pseudorandom number in [0, 1) that depends only on the arguments. Reference: the
/// finalizer of Steele, Lea & Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014.
double uniform(std::uint64_t seed, std::uint64_t sample, std::uint64_t draw) {
  std::uint64_t bits = seed * 0xd1342543de82ef95U + (3 * sample + draw + 1) * 0x9e3779b97f4a7c15U;
  bits = (bits ^ bits >> 30) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ bits >> 27) * 0x94d049bb133111ebU;
  bits ^= bits >> 31;
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

/// Returns a point that is uniform over the triangle if `first` and `second` are uniform in [0, 1).
SurfacePoint point_of_face(const Mesh& mesh, Index index, double first, double second) {
  const Face& face = mesh.faces[index];
  const double root = std::sqrt(first);
  const Vec3& corner = mesh.positions[face[0]];
  return {index, Vec3(1 - root, root * (1 - second), root * second),
          corner + root * (1 - second) * (mesh.positions[face[1]] - corner) +
              root * second * (mesh.positions[face[2]] - corner)};
}

}  // namespace

std::vector<SurfacePoint> surface_points(const Mesh& mesh, std::size_t count, std::uint64_t seed) {
  const double total = surface_area(mesh);
  if (!(total > 0) || count == 0) return {};

  // Sample k is a random point on the face at which the sum of face areas, in face order, reaches
  // the fraction (k + random) / count of the total area.
  std::vector<SurfacePoint> points;
  points.reserve(count);
  const double piece = total / static_cast<double>(count);
  const auto face_count = static_cast<Index>(mesh.faces.size());
  Index face = 0;
  double area_so_far = face_area(mesh, 0);
  for (std::size_t k = 0; k < count; ++k) {
    const double target = (static_cast<double>(k) + uniform(seed, k, 0)) * piece;
    while (area_so_far <= target && face + 1 < face_count) area_so_far += face_area(mesh, ++face);
    points.push_back(point_of_face(mesh, face, uniform(seed, k, 1), uniform(seed, k, 2)));
  }
  return points;
}

std::vector<Vec3> surface_samples(const Mesh& mesh, std::size_t count, std::uint64_t seed) {
  std::vector<Vec3> positions;
  positions.reserve(count);
  for (const SurfacePoint& point : surface_points(mesh, count, seed))
    positions.push_back(point.position);
  return positions;
}

}  // namespace transformesh

#include "tm/evolve/shapes/implicit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "tm/evolve/shapes/lattice.h"
#include "tm/evolve/shapes/relax.h"
#include "tm/mesh/components.h"
#include "tm/mesh/manifold.h"
#include "tm/support/error.h"

namespace transformesh::shapes {
namespace {

constexpr int relax_iterations = 30;
constexpr double good_enough = 0.01;  // relative error of the number of faces

double error_of(const Mesh& mesh, std::size_t faces) {
  return std::abs(std::log(static_cast<double>(mesh.faces.size()) / static_cast<double>(faces)));
}

bool has_topology(const Mesh& mesh, long genus) {
  const ManifoldReport report = check_manifold(mesh);
  if (!report.is_manifold() || !report.is_closed() || !report.is_oriented()) return false;
  const Components parts = connected_components(mesh);
  return parts.components.size() == 1 && parts.components[0].genus() == genus;
}

/// The mesh of right topology whose number of faces is closest to the one wanted. The number goes
/// with the inverse square of the spacing, apart from how the lattice happens to lie.
std::optional<Mesh> march_for(const ImplicitSolid& solid, std::size_t faces,
                              const Progress& progress) {
  double spacing = solid.half_width * 1.6 / std::sqrt(2000.0);
  spacing *= std::sqrt(static_cast<double>(march(solid, spacing).faces.size()) /
                       static_cast<double>(faces));
  std::optional<Mesh> best;
  for (int attempt = 0; attempt < 12; ++attempt) {
    progress("march", attempt / 12.0);
    Mesh mesh = march(solid, spacing);
    spacing *= std::sqrt(std::max<double>(static_cast<double>(mesh.faces.size()), 4) /
                         static_cast<double>(faces)) *
               (1 + 0.003 * attempt);
    if (!has_topology(mesh, solid.genus)) continue;
    if (!best || error_of(mesh, faces) < error_of(*best, faces)) best = std::move(mesh);
    if (error_of(*best, faces) < good_enough) break;
  }
  return best;
}

}  // namespace

Vec3 projected(const ImplicitSolid& solid, Vec3 point) {
  const double step = 1e-5 * solid.half_width;
  for (int iteration = 0; iteration < 4; ++iteration) {
    const double value = solid.function(point);
    Vec3 gradient;
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 ahead = point;
      Vec3 back = point;
      ahead[axis] += step;
      back[axis] -= step;
      gradient[axis] = (solid.function(ahead) - solid.function(back)) / (2 * step);
    }
    const double squared = gradient.squaredNorm();
    if (squared < 1e-6) break;
    point -= value / squared * gradient;
    if (std::abs(value) < 1e-12 * solid.half_width) break;
  }
  return point;
}

Mesh mesh_implicit(const ImplicitSolid& solid, std::size_t faces, const Progress& progress) {
  std::optional<Mesh> mesh = march_for(solid, faces, progress);
  if (!mesh) {
    std::size_t enough = 2 * faces;
    while (!march_for(solid, enough, progress)) enough *= 2;
    throw UsageError(std::to_string(faces) + " faces are too few for this shape; " +
                     std::to_string(enough) + " are enough");
  }
  relax(
      *mesh, [&](const Vec3& point) { return projected(solid, point); }, relax_iterations,
      progress);
  return std::move(*mesh);
}

}  // namespace transformesh::shapes

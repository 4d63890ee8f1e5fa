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
#include "tm/support/parallel.h"

namespace transformesh::shapes {
namespace {

constexpr int relax_iterations = 20;
constexpr std::size_t vertices_per_task = 1024;
constexpr int march_attempts = 16;
constexpr double good_enough = 0.01;  // relative error of the number of faces
constexpr double acceptable = 0.05;

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
/// with the inverse square of the spacing, apart from how the lattice happens to lie; a different
/// lattice each time also helps where the shape is hardly resolved.
std::optional<Mesh> march_for(const ImplicitSolid& solid, std::size_t faces, int attempts,
                              const Progress& progress) {
  std::optional<Mesh> best;
  double spacing = 0.04 * solid.half_width;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    progress("march", static_cast<double>(attempt) / attempts);
    Mesh mesh = march(solid, spacing, static_cast<unsigned>(attempt));
    const double error = error_of(mesh, faces);
    const double excess = static_cast<double>(mesh.faces.size()) / static_cast<double>(faces);
    spacing *= std::clamp(std::sqrt(excess), 0.25, 4.0);
    const bool is_better = error < acceptable && (!best || error < error_of(*best, faces));
    if (!is_better || !has_topology(mesh, solid.genus)) continue;
    best = std::move(mesh);
    if (error < good_enough) break;
  }
  return best;
}

[[noreturn]] void refuse_few(const ImplicitSolid& solid, std::size_t faces,
                             const Progress& progress) {
  std::string advice = "many more are needed";
  for (std::size_t enough = 2 * faces; enough <= 512 * faces && enough < 4000000; enough *= 2) {
    if (!march_for(solid, enough, march_attempts / 2, progress)) continue;
    advice = std::to_string(enough) + " are enough";
    break;
  }
  throw UsageError(std::to_string(faces) + " faces are too few for this shape; " + advice);
}

}  // namespace

Vec3 projected(const ImplicitSolid& solid, const Vec3& point, int iterations) {
  const double step = 1e-5 * solid.half_width;
  Vec3 foot = point;
  for (int iteration = 0; iteration < iterations; ++iteration) {
    const double value = solid.function(foot);
    if (std::abs(value) < 1e-13 * solid.half_width) break;
    Vec3 gradient;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 offset = step * Vec3::Unit(axis);
      gradient[axis] = (solid.function(foot + offset) - solid.function(foot - offset)) / (2 * step);
    }
    const double squared = gradient.squaredNorm();
    if (squared < 1e-6) break;
    foot -= value / squared * gradient;
  }
  return foot;
}

Mesh mesh_implicit(const ImplicitSolid& solid, std::size_t faces, const Progress& progress) {
  std::optional<Mesh> mesh = march_for(solid, faces, march_attempts, progress);
  if (!mesh) refuse_few(solid, faces, progress);
  // While everything moves, nearly on the surface is good enough.
  const auto roughly = [&](const Vec3& point) { return projected(solid, point, 1); };
  relax(*mesh, roughly, relax_iterations, progress);
  parallel_for(mesh->positions.size(), vertices_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v)
      mesh->positions[v] = projected(solid, mesh->positions[v], 6);
  });
  return std::move(*mesh);
}

}  // namespace transformesh::shapes

#include "shapes/implicit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "shapes/lattice.h"
#include "shapes/relax.h"
#include "support/counted.h"
#include "support/elementary/exponential.h"
#include "support/parallel.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/manifold.h"

namespace transformesh::shapes {
namespace {

// A choice: more iterations give rounder triangles and take longer.
constexpr int relax_iterations = 20;
constexpr std::size_t vertices_per_projection_task = 1024;
// A choice: more attempts come closer to the wanted number of faces and take longer.
constexpr int march_attempts = 16;
constexpr double good_enough = 0.01;  // relative error of the number of faces that ends the search
// Largest relative error of the number of faces.
constexpr double acceptable = 0.05;

double error_of(const Mesh& mesh, std::size_t faces) {
  return std::abs(
      elementary::log(static_cast<double>(mesh.faces.size()) / static_cast<double>(faces)));
}

bool has_topology(const Mesh& mesh, long genus) {
  const ManifoldReport report = check_manifold(mesh);
  if (!report.is_manifold() || !report.is_closed() || !report.is_oriented()) return false;
  const Components parts = connected_components(mesh);
  return parts.components.size() == 1 && parts.components[0].genus() == genus;
}

/// Searches for a mesh of the right topology whose number of faces is close to the wanted one. The
/// number is roughly proportional to the inverse square of the lattice spacing. Each attempt places
/// the lattice differently, which changes the number slightly and also helps if the shape is barely
/// resolved.
class MarchSearch {
 public:
  MarchSearch(const ImplicitSolid& solid, const Progress& progress)
      : solid_(solid), progress_(progress), spacing_(0.04 * solid.half_width) {}

  std::optional<Mesh> find(std::size_t faces, int attempts) {
    std::optional<Mesh> best;
    for (int attempt = 0; attempt < attempts; ++attempt) {
      progress_("march", static_cast<double>(attempt) / attempts);
      Mesh mesh = march(solid_, spacing_, variant_++);
      const double error = error_of(mesh, faces);
      const double excess = static_cast<double>(mesh.faces.size()) / static_cast<double>(faces);
      spacing_ *= std::clamp(std::sqrt(excess), 0.25, 4.0);
      const bool is_better = error < acceptable && (!best || error < error_of(*best, faces));
      if (!is_better || !has_topology(mesh, solid_.genus)) continue;
      best = std::move(mesh);
      if (error < good_enough) break;
    }
    return best;
  }

  [[noreturn]] void refuse(std::size_t faces) {
    std::string advice = "many more are needed";
    const std::size_t most = std::clamp<std::size_t>(64 * faces, 20000, 1000000);
    for (std::size_t enough = 2 * faces; enough <= most; enough *= 2) {
      if (!find(enough, 3)) continue;
      advice = std::to_string(enough) + " are enough";
      break;
    }
    throw UsageError(counted(faces, "face") + (faces == 1 ? " is" : " are") +
                     " too few for this shape; " + advice);
  }

 private:
  const ImplicitSolid& solid_;
  const Progress& progress_;
  double spacing_;
  unsigned variant_ = 0;
};

}  // namespace

double smooth_minimum(double a, double b, double width) {
  const double overlap = std::max(width - std::abs(a - b), 0.0) / width;
  return std::min(a, b) - overlap * overlap * width / 4;
}

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
  MarchSearch search(solid, progress);
  std::optional<Mesh> mesh = search.find(faces, march_attempts);
  if (!mesh) search.refuse(faces);
  // One Newton step is enough here, because relaxation moves all vertices again. The last
  // projection below takes more steps.
  const auto roughly = [&](const Vec3& point) { return projected(solid, point, 1); };
  relax(*mesh, roughly, relax_iterations, progress);
  parallel_for(mesh->positions.size(), vertices_per_projection_task,
               [&](std::size_t first, std::size_t last) {
                 for (std::size_t v = first; v < last; ++v)
                   mesh->positions[v] = projected(solid, mesh->positions[v], 6);
               });
  return std::move(*mesh);
}

}  // namespace transformesh::shapes

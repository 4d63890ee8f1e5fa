#include "tm/step/displace.h"

#include <algorithm>
#include <cmath>

#include "tm/mesh/digits.h"
#include "tm/mesh/location_text.h"
#include "tm/mesh/surface_columns.h"
#include "tm/support/error.h"
#include "tm/support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t vertices_per_task = 4096;

void check(const Mesh& mesh, std::span<const Vec3> velocities, const DisplaceOptions& options) {
  if (!std::isfinite(options.time_step)) throw UsageError("the time step is not a finite number");
  if (!(options.alpha >= 0)) throw UsageError("alpha is to be at least 0");
  if (velocities.size() != mesh.positions.size()) {
    throw UsageError("one velocity is needed for each vertex");
  }
  for (std::size_t v = 0; v < velocities.size(); ++v) {
    if (velocities[v].allFinite()) continue;
    throw InputError("the velocity of " + vertex_text(mesh, static_cast<Index>(v)) +
                     " is not a finite number");
  }
}

struct Step {
  Vec3 displacement = Vec3::Zero();
  bool is_clamped = false;
};

/// The velocity is scaled by its largest coordinate first, so that no square overflows.
Step clamped_step(const Vec3& velocity, double time_step, double limit) {
  const double scale = velocity.cwiseAbs().maxCoeff();
  if (scale == 0 || time_step == 0) return {};
  const Vec3 direction = velocity / scale;
  const double length = std::abs(time_step) * scale * direction.norm();
  if (length <= limit) return {time_step * velocity, false};
  return {std::copysign(limit, time_step) * direction.normalized(), true};
}

/// Throws where faces collapse or become flat, because coordinates are farther apart than the edges
/// were.
void check_digits(const Mesh& mesh, const HalfedgeLengths& edges,
                  const std::vector<char>& is_moved) {
  std::size_t lost = 0;
  for (std::size_t v = 0; v < is_moved.size(); ++v) {
    lost += is_moved[v] != 0 &&
            spacing_at(mesh.positions[v].cwiseAbs().maxCoeff()) > edges.vertex_mean[v];
  }
  if (2 * lost > is_moved.size()) {
    throw GoalError(
        "most vertices would go so far that coordinates have no digits for their edges any more");
  }
}

}  // namespace

DisplaceResult displace(Mesh& mesh, std::span<const Vec3> velocities,
                        const DisplaceOptions& options) {
  return displace(mesh, velocities, options, halfedge_lengths(mesh));
}

DisplaceResult displace(Mesh& mesh, std::span<const Vec3> velocities,
                        const DisplaceOptions& options, const HalfedgeLengths& edges) {
  check(mesh, velocities, options);
  const std::size_t count = mesh.positions.size();

  // Move, and note how far each vertex went and how close to its clamp.
  std::vector<double> lengths(count, 0);
  std::vector<double> shares(count, 0);
  std::vector<char> is_clamped(count, 0);
  std::vector<char> is_moved(count, 0);
  parallel_for(count, vertices_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      const double limit = options.alpha * edges.vertex_mean[v];
      const Step step = clamped_step(velocities[v], options.time_step, limit);
      const Vec3 goal = mesh.positions[v] + step.displacement;
      lengths[v] = step.displacement.norm();
      shares[v] = limit > 0 ? lengths[v] / limit : 0;
      is_clamped[v] = step.is_clamped;
      is_moved[v] = goal != mesh.positions[v];
      mesh.positions[v] = goal;
    }
  });

  check_digits(mesh, edges, is_moved);

  // Sum up in the order of the vertices.
  DisplaceResult result;
  double squares = 0;
  for (std::size_t v = 0; v < count; ++v) {
    result.moved += is_moved[v] != 0;
    result.clamped += is_clamped[v] != 0;
    result.max_displacement = std::max(result.max_displacement, lengths[v]);
    result.max_clamp_share = std::max(result.max_clamp_share, shares[v]);
    squares += lengths[v] * lengths[v];
  }
  if (count > 0) result.rms_displacement = std::sqrt(squares / static_cast<double>(count));
  result.mean_edge = edges.mean;
  if (result.moved > 0) result.new_normals = refresh_normals(mesh);
  return result;
}

}  // namespace transformesh

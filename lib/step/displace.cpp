#include "transformesh/displace.h"

#include <algorithm>
#include <cmath>

#include "mesh/coordinate_spacing.h"
#include "mesh/local_measures.h"
#include "mesh/location_text.h"
#include "mesh/surface_columns.h"
#include "step/displace_measured.h"
#include "step/limit_movements.h"
#include "support/parallel.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

constexpr std::size_t moved_per_task = 4096;  ///< affects time only

void check(const Mesh& mesh, std::span<const Vec3> velocities, const DisplaceOptions& options) {
  if (!std::isfinite(options.time_step)) throw UsageError("the time step is not a finite number");
  if (!(options.alpha >= 0)) throw UsageError("alpha must be at least 0");
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

/// Returns time_step * velocity, shortened to `limit`. The velocity is first divided by its largest
/// coordinate, so that no square overflows.
Step clamped_step(const Vec3& velocity, double time_step, double limit) {
  const double scale = velocity.cwiseAbs().maxCoeff();
  if (scale == 0 || time_step == 0) return {};
  const Vec3 direction = velocity / scale;
  const double length = std::abs(time_step) * scale * direction.norm();
  if (length <= limit) return {time_step * velocity, false};
  return {std::copysign(limit, time_step) * direction.normalized(), true};
}

/// Throws GoalError if, at most vertices, the spacing of coordinates exceeds the mean edge length.
/// Faces at such vertices would collapse.
void check_digits(const Mesh& mesh, const HalfedgeLengths& edges,
                  const std::vector<char>& is_moved) {
  std::size_t lost = 0;
  for (std::size_t v = 0; v < is_moved.size(); ++v) {
    lost += is_moved[v] != 0 &&
            spacing_at(mesh.positions[v].cwiseAbs().maxCoeff()) > edges.vertex_mean[v];
  }
  if (2 * lost > is_moved.size()) {
    throw GoalError(
        "most vertices would move so far that coordinates could not resolve their edges");
  }
}

/// Displacements of all vertices, shortened to the largest allowed length. Each vector has one
/// entry for each vertex.
struct AxisDirections {
  std::vector<double> limits;  ///< largest movement of each vertex p: alpha * e_avg(p)
  std::vector<Vec3> displacements;
  std::vector<char> is_clamped;
};

AxisDirections clamped_ways(std::span<const Vec3> velocities, const HalfedgeLengths& edges,
                            const DisplaceOptions& options) {
  const std::size_t count = velocities.size();
  AxisDirections ways{std::vector<double>(count), std::vector<Vec3>(count),
                      std::vector<char>(count, 0)};
  parallel_for(count, moved_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      ways.limits[v] = options.alpha * edges.vertex_mean[v];
      const Step step = clamped_step(velocities[v], options.time_step, ways.limits[v]);
      ways.displacements[v] = step.displacement;
      ways.is_clamped[v] = step.is_clamped;
    }
  });
  return ways;
}

/// Moves the vertices. Returns 1 for each vertex whose position changed.
std::vector<char> move(Mesh& mesh, const std::vector<Vec3>& displacements, Scalar coordinate) {
  std::vector<char> is_moved(displacements.size(), 0);
  parallel_for(is_moved.size(), moved_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      const Vec3 goal = moved_position(mesh.positions[v], displacements[v], coordinate);
      is_moved[v] = goal != mesh.positions[v];
      mesh.positions[v] = goal;
    }
  });
  return is_moved;
}

/// Computes the summary of a step. Sums are in the order of the vertices, hence deterministic.
void summarize(const AxisDirections& ways, const std::vector<char>& is_moved,
               DisplaceResult& result) {
  double squares = 0;
  for (std::size_t v = 0; v < is_moved.size(); ++v) {
    const double length = ways.displacements[v].norm();
    const double share = ways.limits[v] > 0 ? length / ways.limits[v] : 0;
    result.moved += is_moved[v] != 0;
    result.clamped += ways.is_clamped[v] != 0;
    result.max_displacement = std::max(result.max_displacement, length);
    result.max_clamp_share = std::max(result.max_clamp_share, share);
    squares += length * length;
  }
  if (!is_moved.empty())
    result.rms_displacement = std::sqrt(squares / static_cast<double>(is_moved.size()));
}

}  // namespace

DisplaceResult displace_measured(Mesh& mesh, std::span<const Vec3> velocities,
                                 const DisplaceOptions& options, const HalfedgeLengths& edges) {
  check(mesh, velocities, options);
  AxisDirections ways = clamped_ways(velocities, edges, options);
  DisplaceResult result;
  Scalar coordinate = Scalar::float64;
  if (options.keep_out.surface != nullptr) {
    coordinate = options.coordinate;
    const LimitedMovements held =
        limit_movements(mesh, options.keep_out, coordinate, ways.displacements);
    result.held_back = held.held_back;
    result.near_keep_out = held.near;
  }
  const std::vector<char> is_moved = move(mesh, ways.displacements, coordinate);
  check_digits(mesh, edges, is_moved);
  summarize(ways, is_moved, result);
  result.mean_edge = edges.mean;
  if (result.moved > 0) result.new_normals = refresh_normals(mesh);
  return result;
}

DisplaceResult displace(Mesh& mesh, std::span<const Vec3> velocities,
                        const DisplaceOptions& options) {
  return displace_measured(mesh, velocities, options, halfedge_lengths(mesh));
}

}  // namespace transformesh

#include "transformesh/morph_step.h"

#include <algorithm>
#include <limits>

#include "mesh/local_measures.h"
#include "step/displace_measured.h"
#include "step/morph_step_query.h"
#include "step/morph_velocities.h"
#include "step/target_query.h"
#include "support/parallel.h"
#include "transformesh/velocity.h"

namespace transformesh {
namespace {

/// Distances from the target are exact up to this number of mean edge lengths; larger distances are
/// estimated. With a larger value, `from_target` is more accurate early in a morph and needs more
/// searches.
constexpr double far_from_target_in_edges = 4;

/// Smallest value of the column `size`, as a share of the largest value. Limits the number of
/// vertices.
constexpr double least_share = 0.05;

/// Returns the distance from the target beyond which the movement of every vertex is clamped.
/// Larger distances need not be computed exactly. Returns infinity if a mask shortens movements.
double exact_within(const MorphStepOptions& options, const HalfedgeLengths& edges) {
  if (!options.mask.empty()) return std::numeric_limits<double>::infinity();
  const double clamped_beyond = options.displace.alpha * edges.maximum / options.displace.time_step;
  return std::max(clamped_beyond, edges.mean);
}

void set_sizes(Mesh& mesh, std::span<const double> thickness, const MorphStepOptions& options) {
  Column& sizes = mesh.vertex_columns.get("size", Scalar::float64, mesh.positions.size());
  for (std::size_t v = 0; v < thickness.size(); ++v)
    sizes.values[v] = std::clamp(thickness[v] / options.gap_edges,
                                 least_share * options.largest_size, options.largest_size);
}

}  // namespace

MorphStepResult morph_step(Mesh& mesh, const TargetQuery& query, const MorphStepOptions& options,
                           const Progress& progress) {
  const Target& target = query.target();
  MorphStepResult result;
  const auto natural = target.is_mesh() ? MorphDistance::surface : MorphDistance::points;
  result.distance = options.distance.value_or(natural);

  progress("distance to target");
  HalfedgeLengths edges;
  std::vector<Index> order;
  parallel_invoke([&] { edges = halfedge_lengths(mesh); }, [&] { order = surface_order(mesh); });
  MorphVelocities morph;
  parallel_invoke(
      [&] {
        const MorphVelocityOptions how{result.distance, exact_within(options, edges)};
        morph = morph_velocities(mesh, query, how, Progress(), order);
      },
      [&] {
        const double near = far_from_target_in_edges * edges.mean;
        const Target& goal = options.goal != nullptr ? *options.goal : target;
        result.from_target = distance_from_target(goal, mesh, near, Progress(), order);
      });
  result.to_target = morph.to_target;

  if (!options.mask.empty()) apply_mask(mesh, options.mask, morph.velocities);
  if (options.gap_edges > 0 && !morph.thickness.empty()) set_sizes(mesh, morph.thickness, options);
  progress("displace");
  result.displaced = displace_measured(mesh, morph.velocities, options.displace, edges);
  return result;
}

MorphStepResult morph_step(Mesh& mesh, const Target& target, const MorphStepOptions& options,
                           const Progress& progress) {
  return morph_step(mesh, TargetQuery(target), options, progress);
}

}  // namespace transformesh

#include "tm/evolve/morph_step.h"

#include <algorithm>
#include <limits>

#include "tm/evolve/velocity.h"
#include "tm/mesh/measure.h"

namespace transformesh {
namespace {

/// Distances beyond so many mean edges may be estimated.
constexpr double far_in_edges = 4;

// Vertices that are farther move by their clamp, whatever their distance; unless a mask may shorten
// the movement.
double exact_within(const MorphStepOptions& options, const EdgeLengths& edges) {
  if (!options.mask.empty()) return std::numeric_limits<double>::infinity();
  const double clamped_beyond = options.displace.alpha * edges.maximum / options.displace.time_step;
  return std::max(clamped_beyond, far_in_edges * edges.mean);
}

}  // namespace

MorphStepResult morph_step(Mesh& mesh, const Target& target, const MorphStepOptions& options,
                           const Progress& progress) {
  MorphStepResult result;
  const auto natural = target.is_mesh() ? MorphDistance::surface : MorphDistance::vertex;
  result.distance = options.distance.value_or(natural);

  const EdgeLengths edges = edge_lengths(mesh);
  MorphVelocities morph =
      morph_velocities(mesh, target, {result.distance, exact_within(options, edges)}, progress);
  result.to_target = morph.to_target;
  result.from_target = distance_from_target(target, mesh, far_in_edges * edges.mean, progress);

  if (!options.mask.empty()) apply_mask(mesh, options.mask, morph.velocities);
  progress("displace");
  result.displaced = displace(mesh, morph.velocities, options.displace);
  return result;
}

}  // namespace transformesh

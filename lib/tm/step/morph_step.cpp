#include "tm/step/morph_step.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "tm/step/velocity.h"

namespace transformesh {
namespace {

/// Of distances from the target, whose maximum has to come out right when it is some edges.
constexpr double far_from_target_in_edges = 4;
/// Of the largest size, the smallest.
constexpr double least_share = 0.05;

struct EdgeSizes {
  double mean = 0;
  double largest = 0;
};

// By halfedges: an inner edge counts twice.
EdgeSizes edge_sizes(const Mesh& mesh) {
  EdgeSizes sizes;
  for (const auto& [a, b, c] : mesh.faces) {
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      const double length = (mesh.positions[to] - mesh.positions[from]).norm();
      sizes.mean += length;
      sizes.largest = std::max(sizes.largest, length);
    }
  }
  sizes.mean /= 3 * static_cast<double>(mesh.faces.size());
  return sizes;
}

// Vertices that are farther move by their clamp, whatever their distance; unless a mask may shorten
// the movement.
double exact_within(const MorphStepOptions& options, const EdgeSizes& edges) {
  if (!options.mask.empty()) return std::numeric_limits<double>::infinity();
  const double clamped_beyond = options.displace.alpha * edges.largest / options.displace.time_step;
  return std::max(clamped_beyond, 1 * edges.mean);
}

void set_sizes(Mesh& mesh, std::span<const double> gaps, const MorphStepOptions& options) {
  Column& sizes = mesh.vertex_columns.get("size", Scalar::float64, mesh.positions.size());
  for (std::size_t v = 0; v < gaps.size(); ++v)
    sizes.values[v] = std::clamp(gaps[v] / options.gap_edges, least_share * options.largest_size,
                                 options.largest_size);
}

}  // namespace

MorphStepResult morph_step(Mesh& mesh, const Target& target, const MorphStepOptions& options,
                           const Progress& progress) {
  MorphStepResult result;
  const auto natural = target.is_mesh() ? MorphDistance::surface : MorphDistance::points;
  result.distance = options.distance.value_or(natural);

  const EdgeSizes edges = edge_sizes(mesh);
  MorphVelocities morph =
      morph_velocities(mesh, target, {result.distance, exact_within(options, edges)}, progress);
  result.to_target = morph.to_target;
  result.from_target =
      distance_from_target(target, mesh, far_from_target_in_edges * edges.mean, progress);

  if (!options.mask.empty()) apply_mask(mesh, options.mask, morph.velocities);
  if (options.gap_edges > 0 && !morph.gaps.empty()) set_sizes(mesh, morph.gaps, options);
  progress("displace");
  result.displaced = displace(mesh, morph.velocities, options.displace);
  return result;
}

}  // namespace transformesh

/// Evolves a surface with any velocity (paper 5.1, Fig. 8): step, clean and remesh, again and
/// again.
///
///     Mesh mesh = ...;
///     evolve(mesh, step_along([](const Mesh& now, const Progress&) {
///       return std::vector<Vec3>(now.positions.size(), Vec3(0, 0, 1));
///     }), {.until = moved_less_than(1e-4)});
///
/// Guarantees of the result: iteration.h. The source is cleaned first, and the result once more.
/// Throws what the stages throw, with the number of the iteration; the mesh is then that of the
/// last good iteration. Deterministic if the step is.
#pragma once

#include <optional>

#include "transformesh/iteration.h"
#include "transformesh/loop.h"

namespace transformesh {

/// Ends an evolution before its limit of iterations, by how far the vertices moved.
struct UntilRule {
  double least_movement = 0;
  bool is_stalled = false;
  std::optional<long> components = {}, genus = {};  ///< ends if the mesh has as many
};

/// Ends if no vertex moved by `length`, in input units, or farther.
inline UntilRule moved_less_than(double length) { return {length}; }

/// Ends if the root mean square of the movements decreased by less than a hundredth in 20
/// iterations, or if nothing moved.
inline UntilRule stalled() { return {0, true}; }

struct EvolveOptions {
  IterationOptions iteration = {};
  UntilRule until = {};
};

struct EvolveResult {
  std::size_t iterations = 0;  ///< including earlier runs
  bool is_done = false;        ///< ended by the rule, not by the limit of iterations
  /// Iterations in which `alpha` of displace() shortened movements, and the largest fraction of the
  /// vertices in one of them; with those of earlier runs.
  std::size_t clamped_iterations = 0;
  double clamped_share = 0;
  IterationResult last;  ///< last iteration of this run
};

/// Evolves a document, whose columns are carried. A run that continues replaces it by its state.
EvolveResult evolve(Document& document, const Step& step, const EvolveOptions& options = {},
                    const LoopOptions& loop = {}, const Progress& progress = Progress());

/// Evolves a mesh in double precision.
EvolveResult evolve(Mesh& mesh, const Step& step, const EvolveOptions& options = {},
                    const LoopOptions& loop = {}, const Progress& progress = Progress());

}  // namespace transformesh

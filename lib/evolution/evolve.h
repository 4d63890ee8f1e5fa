/// The evolution of paper 5.1 (Fig. 8) with any velocity: step, clean, remesh, again and again. A
/// whole evolution with a velocity of one's own:
///
///     Mesh mesh = ...;
///     evolve(mesh, step_along([](const Mesh& now, const Progress&) {
///       std::vector<Vec3> velocities(now.positions.size(), Vec3(0, 0, 1));
///       return velocities;
///     }), {.until = moved_less_than(1e-4)});
///
/// Guarantees of the result: iteration.h. The start is cleaned first, and the result once more.
/// Throws what the stages throw, a failure of an iteration with its number; the mesh is then that
/// of the last good one. Deterministic where the step is; the record of a run that was ended in any
/// way continues to the same bytes.
#pragma once

#include "evolution/loop/iteration.h"
#include "evolution/loop/loop.h"

namespace transformesh {

/// When an evolution has come to its end, by how far the vertices moved. By default never: the
/// limit of iterations ends it.
struct UntilRule {
  double least_movement = 0;
  bool is_stalled = false;
};
/// No vertex moved by as much as this, in input units.
inline UntilRule moved_less_than(double length) { return {length, false}; }
/// The root mean square of the movements got no smaller by a hundredth in 20 iterations, or nothing
/// moved.
inline UntilRule stalled() { return {0, true}; }

struct EvolveOptions {
  IterationOptions iteration = {};
  UntilRule until = {};
};

struct EvolveResult {
  std::size_t iterations = 0;  ///< earlier runs included
  bool is_done = false;        ///< by the rule, not by the limit of iterations
  /// Iterations in which vertices moved less far than their velocity says, because of `alpha` of
  /// displace(), and the largest share of the vertices in one of them; earlier runs included.
  std::size_t clamped_iterations = 0;
  double clamped_share = 0;
  IterationResult last;  ///< of the last iteration of this run
};

/// "vertices moved less far than their velocities prescribe in 30 of 30 iterations, at most 87 % of
/// them: clamped to 0.2 of the mean edge". Pre: there are such iterations.
std::string clamps_in_words(const EvolveResult& result, double alpha);

EvolveResult evolve(Document& document, const Step& step, const EvolveOptions& options,
                    const LoopOptions& loop, Record& record, const Progress& progress = Progress());

/// In double precision, without a record.
EvolveResult evolve(Mesh& mesh, const Step& step, const EvolveOptions& options = {},
                    const LoopOptions& loop = {}, const Progress& progress = Progress());

}  // namespace transformesh

/// Evolves a surface with any velocity (paper 5.1, Fig. 8): repeats step, clean and remesh.
///
///     Mesh mesh = ...;
///     evolve(mesh, step_along([](const Mesh& now, const Progress&) {
///       return std::vector<Vec3>(now.positions.size(), Vec3(0, 0, 1));
///     }), {.until = moved_less_than(1e-4)});
///
/// Guarantees of the result: iteration.h. The source is cleaned before the first iteration, and the
/// result after the last one. Throws as the stages do, with the number of the iteration; the mesh
/// is then that of the last successful iteration. Deterministic if the step is.
#pragma once

#include <optional>

#include "transformesh/events.h"
#include "transformesh/iteration.h"
#include "transformesh/loop.h"

namespace transformesh {

/// Ends an evolution before its limit of iterations.
struct UntilRule {
  double least_movement = 0;
  bool is_stalled = false;
  std::optional<long> components = {}, genus = {};  ///< end at this count, at this genus
};

/// Ends when no vertex moved by `length`, in input units, or farther.
inline UntilRule moved_less_than(double length) { return {length}; }

/// Ends when the rms movement decreased by less than 1 % in 20 iterations, or no vertex moved.
inline UntilRule stalled() { return {0, true}; }

struct EvolveOptions {
  IterationOptions iteration = {};
  UntilRule until = {};
  bool finds_events = false;  ///< find events (events.h); also done if RecordOptions::events is set
};

struct EvolveResult {
  std::size_t iterations = 0;  ///< number of iterations, including earlier runs
  bool is_done = false;        ///< ended by `until`, not by the limit of iterations
  /// Number of iterations in which `alpha` of displace() shortened movements, and the largest
  /// fraction of shortened vertices in one iteration. Both include earlier runs.
  std::size_t clamped_iterations = 0;
  double clamped_share = 0;
  IterationResult last;                    ///< last iteration of this run
  std::vector<Event> events;               ///< events of this run, with `finds_events`
  std::optional<std::size_t> event_count;  ///< number of events of all runs, with `finds_events`
};

/// Evolves a document and carries its columns. A resumed run starts from its saved state.
EvolveResult evolve(Document& document, const Step& step, const EvolveOptions& options = {},
                    const LoopOptions& loop = {}, const Progress& progress = Progress());

/// Evolves a mesh in double precision.
EvolveResult evolve(Mesh& mesh, const Step& step, const EvolveOptions& options = {},
                    const LoopOptions& loop = {}, const Progress& progress = Progress());

}  // namespace transformesh

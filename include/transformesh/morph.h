/// Evolves a surface until it coincides with a target (paper 5.2): repeats morph_step(), clean()
/// and remesh(). Parts merge and split. The surface reaches target components that it overlaps.
///
/// A morph ends if it makes no progress. It has converged if mesh and target are near each other
/// everywhere and have the same topology; otherwise it has stalled. The final mesh is aligned with
/// sharp edges and cleaned. Columns are carried. Deterministic for any number of threads.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "transformesh/iteration.h"
#include "transformesh/loop.h"
#include "transformesh/morph_step.h"

namespace transformesh {

/// Alignment with sharp edges; `automatic` aligns if the target has_features() (align_features.h).
enum class Features { automatic, on, off };

struct MorphOptions {
  MorphStepOptions step;       ///< morph() measures the target's thickness if `gap_edges` needs it
  IterationOptions iteration;  ///< reference_edge = 0: mean edge of the source
  Features features = Features::automatic;
  int scales = 1;  ///< edges are 2^(scales - 1) times as long at the beginning; 1 to 10
};

enum class MorphStop { iteration_limit, stalled, converged };
struct MorphResult {
  MorphStop stop = MorphStop::iteration_limit;
  std::size_t iterations = 0;  ///< number of iterations, including earlier runs
  Topology topology;
  std::optional<Topology> expected;  ///< target's topology without cavities, if known
  std::size_t left_out = 0;          ///< components of the target that are cavities or inside them
  MorphStepResult distances;         ///< distances between the result and the target
  std::string fault;  ///< why the result does not coincide with the target; else empty
  std::optional<double> to_target, from_target;  ///< Hausdorff distances, if the target has faces
  Problem cause;                                 ///< problem that explains `fault`
  std::size_t aligned = 0;                       ///< vertices on the target's sharp edges
};

/// Morphs a document. Throws as the stages do, and GoalError if no surface is left; the document is
/// then that of the last successful iteration.
MorphResult morph(Document& document, const Target& target, const MorphOptions& options = {},
                  const LoopOptions& loop = {}, const Progress& progress = Progress());

struct TrackResult {
  std::size_t frames = 0, converged = 0;  ///< number of targets, and of targets that were reached
};

/// Follows a moving target (paper 5.2.3, Fig. 11): morphs to the targets that `target_of` returns.
/// `names` are for messages. Repeats a failed morph with short edges at narrow places.
TrackResult track(Document& document, const std::vector<std::string>& names,
                  const std::function<Target(std::size_t frame)>& target_of,
                  const MorphOptions& options = {}, const LoopOptions& loop = {},
                  const Progress& progress = Progress());

}  // namespace transformesh

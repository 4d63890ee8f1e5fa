/// Evolves a surface until it lies on a target (paper 5.2): morph_step(), clean() and remesh(),
/// again and again. The surface merges and splits where it has to, and finds the components of the
/// target that it overlaps.
///
/// Ends as converged if no vertex moves by more than half its clamp, or nothing improves, and mesh
/// and target agree all over: points on each are near the other, and the topology is equal. Ends as
/// stalled if nothing improves and they do not agree. Then vertices and edges are aligned with the
/// target's sharp edges. The result is cleaned once more. Columns are carried. Deterministic.
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "transformesh/iteration.h"
#include "transformesh/loop.h"
#include "transformesh/morph_step.h"

namespace transformesh {

/// Whether to align with sharp edges; automatic: if has_features() of align_features.h.
enum class Features { automatic, on, off };

struct MorphOptions {
  MorphStepOptions step;       ///< `gap_edges`: the target's thickness is measured unless known
  IterationOptions iteration;  ///< `reference_edge` 0: mean edge of the source
  Features features = Features::automatic;
  int scales = 1;  ///< begin with edges 2^(scales - 1) times as long; 1 to 10
};

/// A change that would probably let a morph converge: a clean target, shorter edges where the
/// target is narrow, a source that overlaps all of the target, or shorter edges everywhere.
enum class RemedyKind { none, clean_target, edges_at_narrow_places, larger_source, shorter_edges };
struct MorphRemedy {
  RemedyKind kind = RemedyKind::none;
  double edge = 0;                                         ///< longest edge to use, input units
  double width = std::numeric_limits<double>::infinity();  ///< of the narrowest gap or wall
  Vec3 place = Vec3::Zero();                               ///< of that gap or wall
};

enum class MorphStop { iteration_limit, stalled, converged };
struct MorphResult {
  MorphStop stop = MorphStop::iteration_limit;
  std::size_t iterations = 0;  ///< with those of earlier runs
  Topology topology;
  std::optional<Topology> expected;  ///< of the target if it is known, without its cavities
  std::size_t left_out = 0;          ///< components of the target that are cavities or inside them
  MorphStepResult distances;         ///< of the result
  std::string fault;  ///< why the result does not agree with the target; empty if it does
  std::optional<double> to_target, from_target;  ///< Hausdorff distances, to a target with faces
  MorphRemedy remedy;                            ///< for `fault`
  std::size_t aligned = 0;                       ///< vertices on the target's sharp edges
};

/// Morphs a document. Throws what the stages throw, with the number of the iteration, and GoalError
/// if no surface is left; the document is then that of the last good iteration.
MorphResult morph(Document& document, const Target& target, const MorphOptions& options = {},
                  const LoopOptions& loop = {}, const Progress& progress = Progress());

}  // namespace transformesh

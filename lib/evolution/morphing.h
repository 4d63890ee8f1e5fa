/// Evolves a surface until it lies on a target (paper 5.2): morph_step(), clean(), remesh(), again
/// and again, from coarse to fine where asked for. The surface merges and splits where it has to,
/// and finds the components of the target that it overlaps.
///
/// Ends as converged where no vertex moves by more than half its clamp, or nothing gets better any
/// more, and mesh and target agree (agreement.h); as stalled where nothing gets better and they do
/// not (stop_rules.h). Then vertices and edges are aligned with the target's sharp edges, where it
/// has them (align_features.h), unless the mesh agreed with the target and would no longer. The
/// result is cleaned once more. Columns are carried. Deterministic; the
/// record of a run that was ended in any way continues to the same bytes.
///
/// Throws what the stages throw, a failure of an iteration with its number, and GoalError of the
/// kinds of cause_of_vanishing() (morph_remedy.h) if nothing is left of the surface; the document
/// is then that of the last good one.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "evolution/agreement.h"
#include "evolution/loop/iteration.h"
#include "evolution/loop/loop.h"
#include "step/morph_step.h"

namespace transformesh {

/// Whether to align with sharp edges: automatic where has_features() says that there are any.
enum class Features { automatic, on, off };

struct MorphingOptions {
  /// If `gap_edges` is set, the target's gaps are measured unless they are known, and edge lengths
  /// are factors of the size that the step writes.
  MorphStepOptions step;
  /// `edge_factor` is what the scale makes of it; `reference_edge` 0 is the source's mean edge.
  IterationOptions iteration;
  Features features = Features::automatic;
  int scales = 1;  ///< begin with edges 2^(scales - 1) times as long; 1 to 10
};

enum class MorphingStop { iteration_limit, stalled, converged };
const char* name_of(MorphingStop stop);

struct MorphingResult {
  MorphingStop stop = MorphingStop::iteration_limit;
  std::size_t iterations = 0;  ///< earlier runs included
  Topology topology;
  std::optional<Topology> expected;  ///< that of the target, where it is known
  std::size_t left_out = 0;          ///< components of the target that are no goal (agreement.h)
  MorphStepResult distances;         ///< of the result; nothing moved
  Agreement agreement;
  Problem cause;            ///< of the agreement's fault
  std::size_t aligned = 0;  ///< vertices on the target's sharp edges, where they were aligned
};

MorphingResult morph(Document& document, const Target& target, const MorphingOptions& options,
                     const LoopOptions& loop, Record& record,
                     const Progress& progress = Progress());

}  // namespace transformesh

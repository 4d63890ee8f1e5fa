/// Follows a target that moves (paper 5.2.3, Fig. 11): the surface is morphed to each target of a
/// sequence, starting from the surface before (morph.h).
///
/// Edges keep their length over the sequence, because the reference edge is that of the source.
/// Columns are carried. Where parts of a target touch or separate, components and genus of the
/// surface follow, or the fault names the place where they cannot. A target at which the morph does
/// not converge is tried again with short edges at its narrow places (`gap_edges`); the better
/// surface is kept. Deterministic.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "transformesh/morph.h"

namespace transformesh {

struct TrackResult {
  std::size_t frames = 0;     ///< targets that were reached or given up, with earlier runs
  std::size_t converged = 0;  ///< targets that were reached
};

/// Calls `target_of` for each target in turn. `names` are the names of the targets in messages and
/// rows. The limit of iterations counts for each target; each target is one iteration of the
/// record, and messages are about targets. Throws what morph() throws, with the number of the
/// target.
TrackResult track(Document& document, const std::vector<std::string>& names,
                  const std::function<Target(std::size_t frame)>& target_of,
                  const MorphOptions& options = {}, const LoopOptions& loop = {},
                  const Progress& progress = Progress());

}  // namespace transformesh

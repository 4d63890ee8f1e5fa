/// Follows a target that moves (paper 5.2.3, Fig. 11): a movie of meshes, to each of which the
/// surface of the frame before is morphed (morphing.h). Edges keep their length over the movie, as
/// the reference edge stays that of the first frame; columns are carried from frame to frame. Where
/// limbs touch and part, components and genus follow the target's, or the fault of the frame names
/// the place where they cannot. A frame that does not converge is tried again with short edges in
/// the narrow places of its target (`gap_edges`), and the better one of the two surfaces goes on.
///
/// Each frame is an iteration of the loop: recorded, resumed and limited as such. Throws what
/// morph() throws, with the number of the frame. Deterministic.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "evolution/morphing.h"

namespace transformesh {

struct TrackingResult {
  std::size_t frames = 0;     ///< that are done, those of earlier runs included
  std::size_t converged = 0;  ///< of these
};

/// `target_of` is asked for the target of each frame in turn; `names` are theirs, for rows and
/// messages. The limit of the loop is that of each frame, its messages are those of frames.
TrackingResult track(Document& document, const std::vector<std::string>& names,
                     const std::function<Target(std::size_t frame)>& target_of,
                     const MorphingOptions& options, const LoopOptions& loop, Record& record,
                     const Progress& progress = Progress());

}  // namespace transformesh

/// Whether a morph can get anywhere: what its target and its source have to be (paper 5.2).
///
/// A surface knows which side of a target it is on by the target's orientation alone. Equal
/// positions are one vertex. `name` is that of its file for messages, or empty. Cost: O(n log n),
/// and that of finding intersections; deterministic.
#pragma once

#include <string>
#include <vector>

#include "step/target.h"
#include "support/progress.h"

namespace transformesh {

/// Throws InputError for a target whose faces do not agree which side is outside, and for a closed
/// one that is inside out. Returns what makes a result doubtful, one line each: an open target, and
/// one that intersects itself. Points are not checked.
std::vector<std::string> check_target(const Target& target, const std::string& name,
                                      const Progress& progress = Progress());

/// Throws InputError for a source that is not oriented or inside out. Returns a line where its box
/// does not meet that of the target: then it finds nothing there.
std::vector<std::string> check_source(const Mesh& source, const Target& target,
                                      const std::string& name);

}  // namespace transformesh

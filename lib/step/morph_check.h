/// Whether a morph can get anywhere: what its target and its source have to be (paper 5.2).
///
/// A surface knows which side of a target it is on by the target's orientation alone. Equal
/// positions are one vertex. `name` is that of its file for messages, or empty. Cost: O(n log n),
/// and that of finding intersections; deterministic.
#pragma once

#include <string>
#include <vector>

#include "transformesh/control.h"
#include "transformesh/target.h"

namespace transformesh {

/// Throws InputError for a source that is not oriented or inside out. Returns a warning if its box
/// does not meet that of the target: then it finds nothing there.
std::vector<Problem> check_source(const Mesh& source, const Target& target,
                                  const std::string& name);

}  // namespace transformesh

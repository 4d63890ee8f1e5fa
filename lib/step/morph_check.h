/// Checks the source of a morph (paper 5.2). The sign of the distance to the target, and thus the
/// direction of a morph, follows from the orientation of both meshes. Equal positions count as one
/// vertex. Cost: O(n log n); deterministic.
#pragma once

#include <string>
#include <vector>

#include "transformesh/control.h"
#include "transformesh/target.h"

namespace transformesh {

/// Throws InputError if the source is not oriented or is inside out. Returns a warning if its
/// bounding box does not overlap the target's bounding box: the source would shrink to nothing.
/// `name` is the source's file name for messages, or empty.
std::vector<Problem> check_source(const Mesh& source, const Target& target,
                                  const std::string& name);

}  // namespace transformesh

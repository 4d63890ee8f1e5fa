/// Finds a point in a part of a closed mesh, and its winding number in the whole mesh.
#pragma once

#include "clean/exterior/surroundings.h"
#include "transformesh/measure.h"

namespace transformesh {

/// Returns a point in `box` with its winding number, derived from `known`. The mesh must contain
/// all faces that meet the bounding box of `known` and `box`. Throws GoalError if no such point is
/// found. Deterministic; O(n) per attempted point.
ReferencePoint find_reference(const Mesh& mesh, const ReferencePoint& known, const Box& box);

}  // namespace transformesh

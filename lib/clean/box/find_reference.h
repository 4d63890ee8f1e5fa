/// The reference point of a part of a closed mesh, with its winding number in the whole mesh.
#pragma once

#include "clean/exterior/surroundings.h"
#include "transformesh/measure.h"

namespace transformesh {

/// Returns a point of `box`. The mesh has all faces that meet the smallest box around `known` and
/// `box`. Throws GoalError if no such point is found. Deterministic; O(n).
ReferencePoint find_reference(const Mesh& mesh, const ReferencePoint& known, const Box& box);

}  // namespace transformesh

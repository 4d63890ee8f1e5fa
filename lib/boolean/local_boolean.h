/// A Boolean operation of a large solid and a small operand, restricted to the faces near the
/// operand. These faces are called the part. The arrangement contains the part and the operand
/// only; the rest of the solid stays as it is.
///
/// The rest is not needed to find winding numbers, because the winding number in front of every
/// face of the solid is 0. If the operand meets no face of the solid, a ray finds the winding
/// number at the operand. The solid stays unchanged if the operand is not a simple solid
/// (operand_kinds.h) or has other columns. The solid also stays unchanged if the part is a large
/// share of it, or if rounding would need repairs. Cost: that of boolean() for the part, and a scan
/// of the boxes of all faces. Exact as boolean() is; deterministic.
#pragma once

#include <optional>

#include "boolean/edited_solid.h"
#include "transformesh/boolean.h"

namespace transformesh {

struct LocalBooleanResult {
  std::size_t pairs = 0;          ///< intersecting pairs of faces
  double merge_displacement = 0;  ///< bound on the displacement of the surface by merged flat faces
};

/// Changes the solid, or returns nothing and leaves it unchanged. `operation` must be unite or
/// subtract, and the solid must be a result of boolean().
std::optional<LocalBooleanResult> combine_in_place(BooleanOperation operation, EditedSolid& solid,
                                                   const Mesh& operand,
                                                   const BooleanOptions& options);

}  // namespace transformesh

/// A Boolean operation of a large solid and a small operand, restricted to the faces of the solid
/// near the operand. These faces are called the part. The arrangement contains the part and the
/// operand only; the other faces of the solid (the rest) do not change.
///
/// The rest is not needed to find winding numbers, because the winding number of the solid in front
/// of each of its faces is 0. If the operand meets no face of the solid, a ray finds the winding
/// number of the solid at the operand. The operation is refused, and the solid does not change, in
/// four cases. The winding numbers of the operand are not all 0 or 1 (operand_kinds.h). The operand
/// and the solid have different columns. The part is a large share of the solid. Rounding would
/// need repairs. Cost: that of boolean() for the part, and a scan of the boxes of all faces. Exact
/// as boolean() is; deterministic.
#pragma once

#include <optional>

#include "boolean/edited_solid.h"
#include "transformesh/boolean.h"

namespace transformesh {

struct LocalBooleanResult {
  std::size_t pairs = 0;          ///< number of intersecting pairs of faces
  double merge_displacement = 0;  ///< bound on the displacement of the surface by merged flat faces
};

/// Applies the operation to the solid in place. Returns nothing, and leaves the solid unchanged, if
/// the operation is refused. `operation` must be unite or subtract, and the solid must be a result
/// of boolean().
std::optional<LocalBooleanResult> combine_in_place(BooleanOperation operation, EditedSolid& solid,
                                                   const Mesh& operand,
                                                   const BooleanOptions& options);

}  // namespace transformesh

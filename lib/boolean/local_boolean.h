/// A Boolean operation in the place where a small operand meets a large solid. The faces of the
/// solid there and all of the operand are arranged; the rest of the solid stays as it is.
///
/// The rest need not be known, as the winding number in front of a face of the solid is 0. A ray
/// finds the winding number at an operand that meets no face. Nothing is changed if the operand is
/// not a simple solid or has other columns, or if the part is a large share of the whole. The same
/// holds if rounding has to be repaired. Cost: that of the faces in the box around the faces that
/// the operand's box touches, and a scan of the boxes of all faces. Exact as boolean() is;
/// deterministic.
#pragma once

#include <optional>

#include "boolean/edited_solid.h"
#include "transformesh/boolean.h"

namespace transformesh {

struct LocalBooleanResult {
  std::size_t pairs = 0;          ///< intersecting pairs of faces
  double merge_displacement = 0;  ///< a bound of how far merging moved the surface
};

/// `operation` is unite or subtract. The solid is a result of boolean().
std::optional<LocalBooleanResult> combine_in_place(BooleanOperation operation, EditedSolid& solid,
                                                   const Mesh& operand,
                                                   const BooleanOptions& options);

}  // namespace transformesh

/// Finds bounds for the winding numbers of each operand of a Boolean operation, without an
/// arrangement. If the bounds are tight enough, the sum of the winding numbers of all operands
/// decides which points belong to the result (boolean.cpp). Exact. Cost: O(n), and a ray for each
/// component of an operand.
#pragma once

#include <span>
#include <vector>

#include "boolean/operands.h"
#include "clean/intersect/find_meetings.h"
#include "clean/intersect/welded_mesh.h"

namespace transformesh {

enum class OperandKind {
  simple,        ///< the winding number is 0 or 1 everywhere
  not_negative,  ///< the winding number is >= 0 everywhere
  unknown        ///< the winding number may have any value, and the operand may be open
};

/// Returns the kind of each operand. `welded` is the welded mesh of all operands, and `meetings`
/// are its intersecting pairs of faces.
std::vector<OperandKind> find_operand_kinds(const WeldedMesh& welded,
                                            std::span<const Meeting> meetings,
                                            const JoinedOperands& operands);

}  // namespace transformesh

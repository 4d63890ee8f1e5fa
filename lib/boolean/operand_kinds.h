/// Which values the winding number w of each operand takes, as far as is known without an
/// arrangement. Where these are simple, one winding number of all operands together decides a
/// Boolean operation. Exact. Cost: O(n), and a ray for each component of an operand.
#pragma once

#include <span>
#include <vector>

#include "boolean/operands.h"
#include "clean/intersect/find_meetings.h"
#include "clean/intersect/welded_mesh.h"

namespace transformesh {

enum class OperandKind {
  simple,        ///< w is 0 or 1
  not_negative,  ///< w >= 0
  unknown        ///< any w; the operand may be open
};

/// Per operand. `meetings` are those of the welded mesh of all operands.
std::vector<OperandKind> find_operand_kinds(const WeldedMesh& welded,
                                            std::span<const Meeting> meetings,
                                            const JoinedOperands& operands);

}  // namespace transformesh

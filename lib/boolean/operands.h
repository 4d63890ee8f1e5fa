/// The operands of a Boolean operation as one mesh: one after the other, those that are subtracted
/// reversed. O(n).
#pragma once

#include <vector>

#include "transformesh/boolean.h"

namespace transformesh {

struct JoinedOperands {
  Mesh mesh;
  std::vector<Index> operand_of;  ///< per face of the mesh
  std::vector<char> is_reversed;  ///< per operand
};

/// A difference subtracts all operands but the first.
JoinedOperands join_operands(BooleanOperation operation, const std::vector<Operand>& operands);

/// Throws InputError, naming the operand, unless each is closed and oriented.
void check_solids(const std::vector<Operand>& operands);

}  // namespace transformesh

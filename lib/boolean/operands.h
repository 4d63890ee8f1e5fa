/// Concatenates the operands of a Boolean operation to one mesh, in their order. Subtracted
/// operands are reversed. O(n).
#pragma once

#include <deque>
#include <vector>

#include "transformesh/boolean.h"

namespace transformesh {

struct JoinedOperands {
  Mesh mesh;
  std::vector<Index> operand_of;  ///< operand of each face of `mesh`
  std::vector<char> is_reversed;  ///< 1 for each operand that is reversed
};

/// Returns the operands with positions rounded to the type. If rounding changes a mesh, the rounded
/// mesh is appended to `rounded`, and the operand refers to it.
std::vector<Operand> rounded_operands(std::vector<Operand> operands, Scalar coordinate,
                                      std::deque<Mesh>& rounded);

/// Joins the operands. BooleanOperation::subtract reverses all operands except the first.
JoinedOperands join_operands(BooleanOperation operation, const std::vector<Operand>& operands);

/// Throws InputError, naming the operand, if an operand is not closed or not oriented.
void check_solids(const std::vector<Operand>& operands);

}  // namespace transformesh

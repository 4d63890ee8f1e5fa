/// The winding numbers of all operands at one place, and whether a Boolean operation selects that.
#pragma once

#include <vector>

#include "transformesh/boolean.h"

namespace transformesh {

class OperandWindings {
 public:
  /// All are 0.
  OperandWindings(BooleanOperation operation, std::size_t operands)
      : operation_(operation), winding_(operands, 0), encloses_(operands, 0) {}

  /// O(1).
  void change(Index operand, int by);
  bool is_selected() const;
  /// Per operand: whether it had w >= 1 after any change.
  const std::vector<char>& encloses() const { return encloses_; }

 private:
  BooleanOperation operation_;
  std::vector<int> winding_;  ///< per operand
  std::vector<char> encloses_;
  std::size_t inside_of_ = 0;  ///< operands with w >= 1
};

}  // namespace transformesh

/// The winding numbers of all operands at one place, and whether a Boolean operation selects that.
#pragma once

#include <vector>

#include "transformesh/boolean.h"

namespace transformesh {

/// Whether the winding number of an operand is positive or negative anywhere.
struct WindingSigns {
  bool is_positive = false, is_negative = false;
};

class OperandWindings {
 public:
  /// All are 0.
  OperandWindings(BooleanOperation operation, std::size_t operands)
      : operation_(operation), winding_(operands, 0), signs_(operands) {}

  /// O(1).
  void change(Index operand, int by);
  bool is_selected() const;
  /// Per operand, of all the numbers that it has had.
  const std::vector<WindingSigns>& signs() const { return signs_; }

 private:
  BooleanOperation operation_;
  std::vector<int> winding_;  ///< per operand
  std::vector<WindingSigns> signs_;
  std::size_t inside_of_ = 0;  ///< operands with w >= 1
};

}  // namespace transformesh

/// The winding numbers of all operands in one cell of space, and whether a Boolean operation
/// selects the cell. The caller moves from cell to cell and changes the winding numbers.
#pragma once

#include <vector>

#include "transformesh/boolean.h"

namespace transformesh {

/// Signs of the winding numbers of an operand. `is_positive` is true if the winding number is
/// positive in any cell of space, and `is_negative` if it is negative in any cell.
struct WindingSigns {
  bool is_positive = false, is_negative = false;
};

class OperandWindings {
 public:
  /// Starts in a cell in which all winding numbers are 0.
  OperandWindings(BooleanOperation operation, std::size_t operands)
      : operation_(operation), winding_(operands, 0), signs_(operands) {}

  /// Adds `by` to the winding number of an operand. O(1).
  void change(Index operand, int by);
  bool is_selected() const;
  /// Returns for each operand which signs its winding number has had so far, in any visited cell.
  const std::vector<WindingSigns>& signs() const { return signs_; }

 private:
  BooleanOperation operation_;
  std::vector<int> winding_;  ///< winding number of each operand in the current cell
  std::vector<WindingSigns> signs_;
  std::size_t inside_of_ = 0;  ///< number of operands with winding number >= 1
};

}  // namespace transformesh

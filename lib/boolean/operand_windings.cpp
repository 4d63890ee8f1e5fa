#include "boolean/operand_windings.h"

namespace transformesh {

void OperandWindings::change(Index operand, int by) {
  int& winding = winding_[operand];
  const bool was_inside = winding >= 1;
  winding += by;
  const bool is_inside = winding >= 1;
  if (is_inside && !was_inside) ++inside_of_;
  signs_[operand].is_positive |= winding > 0;
  signs_[operand].is_negative |= winding < 0;
  if (was_inside && !is_inside) --inside_of_;
}

bool OperandWindings::is_selected() const {
  switch (operation_) {
    case BooleanOperation::unite:
      return inside_of_ > 0;
    case BooleanOperation::intersect:
      return inside_of_ == winding_.size();
    case BooleanOperation::subtract:
      return inside_of_ == 1 && winding_[0] >= 1;
    case BooleanOperation::exclude:
      break;
  }
  return inside_of_ % 2 == 1;
}

}  // namespace transformesh

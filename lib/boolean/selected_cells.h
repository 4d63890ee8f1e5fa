/// Chooses the pieces between cells of space that a Boolean operation selects and cells that it
/// does not (Zhou et al. 2016). A ray finds the winding numbers of all operands in one cell of
/// every connected set of pieces. From cell to cell they change by the sources of the pieces
/// between them. Exact. Cost: O(n log n), whatever the number of operands. Deterministic.
#pragma once

#include "boolean/operands.h"
#include "clean/arrange/arrange.h"

namespace transformesh {

/// What the arrangement has of the first operand: all faces, or a part of a solid without
/// intersections. In front of such faces it has the winding number 0, behind them 1.
enum class FirstOperand { whole, part };

/// Does what PieceChooser::choose() says. Returns false if a part does not tell whether pieces are
/// to be chosen: nothing connects them with a face of the part.
bool choose_selected(BooleanOperation operation, const JoinedOperands& operands, FirstOperand first,
                     Arrangement& arrangement, std::vector<char>& kept);

}  // namespace transformesh

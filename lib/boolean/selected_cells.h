/// Chooses the pieces between cells of space that a Boolean operation selects and cells that it
/// does not (Zhou et al. 2016). A ray finds the winding numbers of all operands in one cell of
/// every connected set of pieces. From cell to cell they change by the sources of the pieces
/// between them. Exact. Cost: O(n log n), whatever the number of operands. Deterministic.
#pragma once

#include "boolean/operands.h"
#include "clean/arrange/arrange.h"

namespace transformesh {

/// Does what PieceChooser::choose() says.
void choose_selected(BooleanOperation operation, const JoinedOperands& operands,
                     Arrangement& arrangement, std::vector<char>& kept);

}  // namespace transformesh

/// Chooses the pieces between cells of space that a Boolean operation selects and cells that it
/// does not (Zhou et al. 2016). The winding numbers of all operands are known in one cell of every
/// connected set of pieces, from a ray, and change from cell to cell by the sources of the pieces
/// between them. Exact. Cost: O(n log n), whatever the number of operands. Deterministic.
#pragma once

#include "boolean/operands.h"
#include "clean/arrange/arrange.h"

namespace transformesh {

/// As PieceChooser::choose.
void choose_selected(BooleanOperation operation, const JoinedOperands& operands,
                     Arrangement& arrangement, std::vector<char>& kept);

}  // namespace transformesh

/// Chooses the pieces that close a part of a sheet together with the surface of a solid: the
/// boundary of the region that is inside (or outside) the solid, and behind the sheet. The region
/// consists of the cells of space between pieces of both (Zhou et al. 2016). It is defined if all
/// borders of the part lie on the surface, no cell is both in front of the sheet and behind it, and
/// no cell behind it is unbounded. Deterministic.
#pragma once

#include "clean/arrange/arrange.h"
#include "transformesh/boolean.h"

namespace transformesh {

/// Does what PieceChooser::choose() says. `arrangement` is that of a closed solid, of which all
/// pieces are known by their winding number, and of a sheet as an open component. Chooses nothing
/// if no part of the sheet is on that side. Throws InputError if the region is not defined.
void choose_capped_sheet(SheetSide side, Arrangement& arrangement, std::vector<char>& kept);

/// Whether a piece belongs to the part of the sheet on that side.
inline bool is_on_side(const Piece& piece, SheetSide side) {
  return piece.is_open && (piece.front >= 1) == (side == SheetSide::inside);
}

}  // namespace transformesh

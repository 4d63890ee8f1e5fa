/// Chooses pieces of a sheet and of a solid that bound a region together. The region is inside (or
/// outside) the solid, and behind the sheet. It consists of the cells of space between the pieces.
/// The region is defined under three conditions. All borders of the kept part of the sheet lie on
/// the surface of the solid. No cell is both in front of the sheet and behind it. No cell behind it
/// is unbounded. Deterministic. Reference: Zhou, Grinspun, Zorin & Jacobson, "Mesh arrangements for
/// solid geometry", ACM TOG 35(4), 2016.
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

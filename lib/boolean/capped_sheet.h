/// Chooses the pieces of a sheet (an open surface) and of a solid that together bound a region. The
/// region is behind the sheet, and inside or outside the solid. It is a union of cells, the parts
/// into which the pieces divide space. The region is defined under three conditions:
/// - All borders of the kept part of the sheet are on the surface of the solid.
/// - No cell is both in front of the sheet and behind it.
/// - No cell behind the sheet is unbounded.
/// Cost: that of join_nested_cells(). Deterministic. Reference for the cells: Zhou, Grinspun, Zorin
/// & Jacobson, "Mesh arrangements for solid geometry", ACM TOG 35(4), 2016.
#pragma once

#include "clean/arrange/arrange.h"
#include "transformesh/boolean.h"

namespace transformesh {

/// Implements PieceChooser::choose(). `arrangement` contains the pieces of a closed solid, and
/// those of an open surface, the sheet. The winding number of the solid in front of each piece is
/// set. Chooses nothing if no part of the sheet is on `side` of the solid. Throws InputError if the
/// region is not defined.
void choose_capped_sheet(SheetSide side, Arrangement& arrangement, std::vector<char>& kept);

/// True if a piece belongs to the sheet and lies on `side` of the solid.
inline bool is_on_side(const Piece& piece, SheetSide side) {
  return piece.is_open && (piece.front >= 1) == (side == SheetSide::inside);
}

}  // namespace transformesh

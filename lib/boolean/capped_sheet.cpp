#include "boolean/capped_sheet.h"

#include <algorithm>
#include <string>

#include "boolean/nested_cells.h"
#include "clean/exterior/angular_order.h"
#include "clean/exterior/patches.h"
#include "mesh/location_text.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

std::array<double, 3> array_of(const Vec3& point) { return {point.x(), point.y(), point.z()}; }

/// True if a piece belongs to the boundary of the solid: the outside of the solid is in front of
/// the piece, and the inside is behind it.
bool is_surface(const Piece& piece) {
  return !piece.is_open && piece.front < 1 && piece.front + piece.multiplicity >= 1;
}

/// Removes pieces from the arrangement by setting their multiplicity to 0. Only pieces of the sheet
/// on `side` of the solid, and of the boundary of the solid, remain. Returns true if pieces of the
/// sheet remain.
bool keep_dividing(SheetSide side, Arrangement& arrangement) {
  bool has_sheet = false;
  for (Piece& piece : arrangement.pieces) {
    const bool is_part = is_on_side(piece, side) && piece.multiplicity != 0;
    has_sheet |= is_part;
    if (!is_part && !is_surface(piece)) piece.multiplicity = 0;
  }
  return has_sheet;
}

// Throws InputError if an edge has only one remaining piece. The boundary of the solid has no such
// edge, so the edge is a border of the sheet that is not on the solid's surface.
void refuse_borders(SheetSide side, const Arrangement& arrangement) {
  std::vector<char> counts(arrangement.pieces.size());
  for (std::size_t p = 0; p < counts.size(); ++p)
    counts[p] = arrangement.pieces[p].multiplicity != 0 ? 1 : 0;
  const Edges edges = piece_edges(arrangement, counts);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto halfedges = edges.halfedges(e);
    if (halfedges.size() != 1) continue;
    const auto& pieces = arrangement.pieces;
    const Vec3 middle = arrangement.position(halfedge_source(pieces, halfedges[0])) / 2 +
                        arrangement.position(halfedge_target(pieces, halfedges[0])) / 2;
    throw InputError(ErrorKind::other,
                     std::string("the sheet ends ") +
                         (side == SheetSide::inside ? "inside" : "outside") + " the solid, at " +
                         point_text(middle) + ": a cap cannot close it there",
                     {.position = array_of(middle)});
  }
}

/// Finds the cells of space behind the sheet. A cell is a region of space that is bounded by
/// patches (connected pieces of faces). Marks the patch sides on the boundary of these cells.
class CellsBehind {
 public:
  CellsBehind(const Arrangement& arrangement, const Patches& patches)
      : arrangement_(arrangement),
        patches_(patches),
        sides_(join_sides_around_edges(arrangement, patches)),
        outermost_(join_nested_cells(arrangement, patches, sides_)),
        is_front_(2 * patches.size(), 0),
        is_behind_(2 * patches.size(), 0) {}
  std::vector<char> find();

 private:
  const Piece& piece_of(Index patch) const {
    return arrangement_.pieces[patches_.pieces[patch].front()];
  }
  void mark(Index patch);

  const Arrangement& arrangement_;
  const Patches& patches_;
  DisjointSets sides_;
  Index outermost_;  ///< one side of a patch that bounds the unbounded cell
  /// 1 for each cell in front of the sheet. The index of a cell is that of its representative patch
  /// side in `sides_`.
  std::vector<char> is_front_;
  std::vector<char> is_behind_;  ///< 1 for each cell behind the sheet; indexed like `is_front_`
};

void CellsBehind::mark(Index patch) {
  const Index front = sides_.find(2 * patch), behind = sides_.find(2 * patch + 1);
  is_front_[front] = is_behind_[behind] = 1;
  if (!is_front_[behind] && !is_behind_[front]) return;
  const Vec3 place = arrangement_.position(piece_of(patch).corners[0]);
  throw InputError(
      ErrorKind::other,
      "a region at " + point_text(place) +
          " lies in front of one part of the sheet and behind another: a cap cannot close both",
      {.position = array_of(place)});
}

std::vector<char> CellsBehind::find() {
  for (Index patch = 0; patch < patches_.size(); ++patch)
    if (piece_of(patch).is_open) mark(patch);
  if (is_behind_[sides_.find(outermost_)])
    throw InputError(ErrorKind::inside_out,
                     "the region behind the sheet is not bounded: the sheet may be reversed");
  std::vector<char> of_side;
  for (Index side = 0; side < is_behind_.size(); ++side)
    of_side.push_back(is_behind_[sides_.find(side)]);
  return of_side;
}

}  // namespace

void choose_capped_sheet(SheetSide side, Arrangement& arrangement, std::vector<char>& kept) {
  if (!keep_dividing(side, arrangement)) return;
  refuse_borders(side, arrangement);
  const Patches patches(arrangement);
  keep_boundary(arrangement, patches, CellsBehind(arrangement, patches).find(), kept);
}

}  // namespace transformesh

#include "boolean/selected_cells.h"

#include <map>
#include <utility>

#include "boolean/operand_windings.h"
#include "clean/exterior/angular_order.h"
#include "clean/exterior/patches.h"
#include "clean/exterior/ray_cast_front_winding.h"

namespace transformesh {
namespace {

/// The changes of the winding numbers from the front of a piece to its back: pairs of an operand
/// and its change. Sorted by operand; operands without a change are left out.
using Jumps = std::vector<std::pair<Index, int>>;

/// Numbers the different lists of jumps (changes of winding numbers) in an arrangement. The
/// constructor stores the number of a piece's list in its `multiplicity`. Patches (connected
/// pieces) contain only pieces of equal multiplicity. Hence all pieces of a patch have the same
/// jumps.
class PieceJumps {
 public:
  PieceJumps(const JoinedOperands& operands, Arrangement& arrangement);
  const Jumps& of(const Piece& piece) const {
    return *numbered_[static_cast<std::size_t>(piece.multiplicity)];
  }
  int of_first_operand(const Piece& piece) const {
    const Jumps& jumps = of(piece);
    return !jumps.empty() && jumps.front().first == 0 ? jumps.front().second : 0;
  }

 private:
  std::map<Jumps, std::int32_t> numbers_;
  std::vector<const Jumps*> numbered_;  ///< maps each number to its list of jumps; list 0 is empty
};

PieceJumps::PieceJumps(const JoinedOperands& operands, Arrangement& arrangement) {
  const auto number_of = [this](const Jumps& jumps) {
    const auto [at, is_new] =
        numbers_.try_emplace(jumps, static_cast<std::int32_t>(numbers_.size()));
    if (is_new) numbered_.push_back(&at->first);
    return at->second;
  };
  number_of({});
  std::map<Index, int> sums;
  for (Piece& piece : arrangement.pieces) {
    sums.clear();
    for (const PieceSource& source : arrangement.sources_of(piece)) {
      const Index operand = operands.operand_of[arrangement.welded->face_of[source.face]];
      sums[operand] += source.reversed == (operands.is_reversed[operand] != 0) ? 1 : -1;
    }
    std::erase_if(sums, [](const auto& sum) { return sum.second == 0; });
    piece.multiplicity = number_of(Jumps(sums.begin(), sums.end()));
  }
}

class SelectedCells {
 public:
  SelectedCells(BooleanOperation operation, const JoinedOperands& operands,
                const WindingAt& first_at, Arrangement& arrangement);
  /// Returns for each side of a patch (patches.h) whether the cell on this side is selected.
  /// Returns an empty list if `first_at` returned no winding number where one was needed.
  std::vector<char> find();
  const Patches& patches() const { return patches_; }
  /// Returns for each operand which signs of winding numbers occur; call find() first.
  const std::vector<WindingSigns>& signs() const { return signs_; }

 private:
  struct Step {
    Index cell;
    Index through;  ///< side of a patch through which the search entered the cell, or no_index
    std::size_t next = 0;  ///< index of the next side of the cell to visit
  };

  const Piece& piece_at(Index side) const;
  void cross(OperandWindings& windings, Index side, int sign) const;
  bool is_whole_edge(std::span<const Index> halfedges) const;
  std::optional<int> first_at_patch(Index patch) const;
  std::optional<int> first_in_front_of(Index patch) const;
  std::optional<OperandWindings> windings_at(Index side) const;
  bool spread_from(Index side);
  void enter(Index cell, const OperandWindings& windings);

  static constexpr char unknown = 2;  ///< a value other than 0 (not selected) and 1 (selected)

  BooleanOperation operation_;
  const JoinedOperands& operands_;
  /// Function that returns winding numbers of the first operand. Empty if the arrangement contains
  /// all faces of this operand.
  const WindingAt& first_at_;
  Arrangement& arrangement_;
  PieceJumps jumps_;
  Patches patches_;
  RayCastFrontWinding ray_;
  std::vector<Index> cell_of_;  ///< cell of space at each side of each patch
  /// Patch sides on the boundary of each cell. The index of a cell is that of one of these sides.
  std::vector<std::vector<Index>> sides_;
  std::vector<char> is_selected_;    ///< for each cell 0, 1 or `unknown`
  std::vector<WindingSigns> signs_;  ///< for each operand which signs of winding numbers occur
  /// Stack of the depth-first search: the cells from the first to the current cell.
  std::vector<Step> way_;
};

SelectedCells::SelectedCells(BooleanOperation operation, const JoinedOperands& operands,
                             const WindingAt& first_at, Arrangement& arrangement)
    : operation_(operation),
      operands_(operands),
      first_at_(first_at),
      arrangement_(arrangement),
      jumps_(operands, arrangement),
      patches_(arrangement),
      ray_(*arrangement.welded, patches_.size()),
      signs_(operands.is_reversed.size()) {
  IsWholeEdge is_whole;
  if (first_at)
    is_whole = [this](std::span<const Index> halfedges) { return is_whole_edge(halfedges); };
  DisjointSets sides = join_sides_around_edges(arrangement, patches_, is_whole);
  sides_.resize(2 * patches_.size());
  for (Index side = 0; side < sides_.size(); ++side) {
    cell_of_.push_back(sides.find(side));
    sides_[cell_of_[side]].push_back(side);
  }
  is_selected_.assign(sides_.size(), unknown);
}

// Changes `windings` from the winding numbers in the cell at `side` to those in the cell on the
// other side of the patch. If `sign` is -1, changes them back.
void SelectedCells::cross(OperandWindings& windings, Index side, int sign) const {
  const Piece& piece = piece_at(side);
  const int direction = side % 2 == 0 ? sign : -sign;
  for (const auto& [operand, jump] : jumps_.of(piece)) windings.change(operand, direction * jump);
}

const Piece& SelectedCells::piece_at(Index side) const {
  return arrangement_.pieces[patches_.pieces[side / 2].front()];
}

// True if the first operand traverses the edge equally often in both directions. This is not the
// case at the border of a part of a solid.
bool SelectedCells::is_whole_edge(std::span<const Index> halfedges) const {
  int sum = 0;
  for (const Index h : halfedges) {
    const int jump = jumps_.of_first_operand(arrangement_.pieces[h / 3]);
    sum += is_forward(arrangement_.pieces, h) ? jump : -jump;
  }
  return sum == 0;
}

// Returns the winding number of the first operand at a patch that does not belong to this operand.
// The first operand does not intersect the patch, so its winding number is the same at all corners
// of the patch.
std::optional<int> SelectedCells::first_at_patch(Index patch) const {
  const std::size_t given = arrangement_.welded->points.size();
  for (const Index piece : patches_.pieces[patch])
    for (const Index corner : arrangement_.pieces[piece].corners) {
      if (corner >= given) continue;
      if (const auto winding = first_at_(arrangement_.welded->points[corner])) return winding;
    }
  return std::nullopt;
}

std::optional<int> SelectedCells::first_in_front_of(Index patch) const {
  const int jump = jumps_.of_first_operand(piece_at(2 * patch));
  if (jump == 0) return first_at_patch(patch);
  return jump > 0 ? 0 : 1;
}

std::optional<OperandWindings> SelectedCells::windings_at(Index side) const {
  OperandWindings windings(operation_, operands_.is_reversed.size());
  const Piece& piece = piece_at(side);
  std::map<Index, int> sums;
  for (const FaceCrossing& crossing : ray_.crossings_in_front_of(arrangement_, piece)) {
    const Index operand = operands_.operand_of[arrangement_.welded->face_of[crossing.face]];
    if (first_at_ && operand == 0) continue;
    sums[operand] += operands_.is_reversed[operand] ? -crossing.winding : crossing.winding;
  }
  for (const auto& [operand, sum] : sums) windings.change(operand, sum);
  if (first_at_) {
    const std::optional<int> first = first_in_front_of(side / 2);
    if (!first) return std::nullopt;
    windings.change(0, *first);
  }
  if (side % 2 == 1) cross(windings, side - 1, 1);
  return windings;
}

void SelectedCells::enter(Index cell, const OperandWindings& windings) {
  is_selected_[cell] = windings.is_selected() ? 1 : 0;
}

// Visits the cells that are connected with the cell at `side`, depth first. Stores the winding
// numbers of the current cell only: each change is undone when the search backtracks. Returns false
// if the winding numbers at `side` are not known.
bool SelectedCells::spread_from(Index side) {
  std::optional<OperandWindings> begin = windings_at(side);
  if (!begin) return false;
  OperandWindings& windings = *begin;
  enter(cell_of_[side], windings);
  way_.push_back({cell_of_[side], no_index});
  while (!way_.empty()) {
    Step& step = way_.back();
    if (step.next == sides_[step.cell].size()) {
      if (step.through != no_index) cross(windings, step.through, -1);
      way_.pop_back();
      continue;
    }
    const Index through = sides_[step.cell][step.next++];
    const Index beyond = cell_of_[through ^ 1U];
    if (is_selected_[beyond] != unknown) continue;
    cross(windings, through, 1);
    enter(beyond, windings);
    way_.push_back({beyond, through});
  }
  for (std::size_t i = 0; i < signs_.size(); ++i) {
    signs_[i].is_positive |= windings.signs()[i].is_positive;
    signs_[i].is_negative |= windings.signs()[i].is_negative;
  }
  return true;
}

// Starts the search at patches of the first operand, because there the winding number of the first
// operand is known without a call of `first_at_`.
std::vector<char> SelectedCells::find() {
  std::vector<char> of_side;
  for (Index side = 0; side < sides_.size(); ++side) {
    const bool is_known = !first_at_ || jumps_.of_first_operand(piece_at(side)) != 0;
    if (is_known && is_selected_[cell_of_[side]] == unknown) spread_from(side);
  }
  for (Index side = 0; side < sides_.size(); ++side)
    if (is_selected_[cell_of_[side]] == unknown && !spread_from(side)) return {};
  of_side.reserve(sides_.size());
  for (const Index cell : cell_of_) of_side.push_back(is_selected_[cell]);
  return of_side;
}

}  // namespace

Selection choose_selected(BooleanOperation operation, const JoinedOperands& operands,
                          const WindingAt& first_at, Arrangement& arrangement,
                          std::vector<char>& kept) {
  SelectedCells cells(operation, operands, first_at, arrangement);
  const std::vector<char> is_selected = cells.find();
  const bool is_known = !is_selected.empty() || cells.patches().size() == 0;
  if (is_known) keep_boundary(arrangement, cells.patches(), is_selected, kept);
  return {is_known, cells.signs()};
}

}  // namespace transformesh

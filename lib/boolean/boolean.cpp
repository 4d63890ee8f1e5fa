#include "transformesh/boolean.h"

#include <algorithm>
#include <array>

#include "boolean/operand_kinds.h"
#include "boolean/operands.h"
#include "boolean/selected_cells.h"
#include "clean/whole/clean_whole.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

constexpr const char* operand_column = "source_operand";

/// Kinds of the errors which say that a region is empty, in exact numbers or once rounded.
constexpr std::array empty_region_kinds{ErrorKind::no_positive_winding, ErrorKind::no_such_level,
                                        ErrorKind::canceling_faces, ErrorKind::no_area,
                                        ErrorKind::thinner_than_rounding};

/// Chooses the boundary of what a Boolean operation selects.
class SolidChooser : public PieceChooser {
 public:
  SolidChooser(BooleanOperation operation, const std::vector<Operand>& operands,
               const JoinedOperands& joined, std::vector<char>& encloses)
      : operation_(operation), operands_(operands), joined_(joined), encloses_(encloses) {}

  void mark_open(WeldedMesh& /*welded*/) const override {}
  bool is_level_set(const WeldedMesh& welded, const std::vector<Meeting>& meetings) const override;
  void choose(Arrangement& arrangement, std::vector<char>& kept) const override {
    encloses_ = choose_selected(operation_, joined_, WindingAt(), arrangement, kept).encloses;
  }

 private:
  BooleanOperation operation_;
  const std::vector<Operand>& operands_;
  const JoinedOperands& joined_;
  std::vector<char>& encloses_;  ///< per operand; set when pieces are chosen
};

// The sum of winding numbers is at least 1 where any is, if none is negative. It reaches the number
// of operands only where each is 1, if none is more. Less those of subtracted operands it is 1 only
// inside the first operand alone, if that is nowhere more.
bool SolidChooser::is_level_set(const WeldedMesh& welded,
                                const std::vector<Meeting>& meetings) const {
  const std::vector<OperandKind> kinds = find_operand_kinds(welded, meetings, joined_);
  const auto is_simple = [](OperandKind kind) { return kind == OperandKind::simple; };
  const auto is_unknown = [](OperandKind kind) { return kind == OperandKind::unknown; };
  const bool is_any_unknown = std::any_of(kinds.begin(), kinds.end(), is_unknown);
  if (is_any_unknown) check_solids(operands_);
  switch (operation_) {
    case BooleanOperation::unite:
      return !is_any_unknown;
    case BooleanOperation::intersect:
      return std::all_of(kinds.begin(), kinds.end(), is_simple);
    case BooleanOperation::subtract:
      return !is_any_unknown && is_simple(kinds[0]);
    case BooleanOperation::exclude:
      break;
  }
  return false;
}

/// Chooses the faces of the first operand on one side of the others.
class SheetChooser : public PieceChooser {
 public:
  SheetChooser(SheetSide side, const JoinedOperands& joined) : side_(side), joined_(joined) {}

  void mark_open(WeldedMesh& welded) const override {
    for (const Index face : welded.face_of)
      welded.open_component.push_back(joined_.operand_of[face] == 0 ? 0 : no_index);
  }
  bool is_level_set(const WeldedMesh& /*welded*/,
                    const std::vector<Meeting>& /*meetings*/) const override {
    return false;
  }
  void choose(Arrangement& arrangement, std::vector<char>& kept) const override {
    for (std::size_t p = 0; p < kept.size(); ++p) {
      const Piece& piece = arrangement.pieces[p];
      kept[p] = piece.is_open && (piece.front >= 1) == (side_ == SheetSide::inside) ? 1 : 0;
    }
  }

 private:
  SheetSide side_;
  const JoinedOperands& joined_;
};

void number_operands(JoinedOperands& joined) {
  Mesh& mesh = joined.mesh;
  Column& column = mesh.face_columns.get(operand_column, Scalar::int32, mesh.faces.size());
  std::copy(joined.operand_of.begin(), joined.operand_of.end(), column.values.begin());
}

CleanResult clean_joined(JoinedOperands& joined, const PieceChooser& chooser, int winding_level,
                         const BooleanOptions& options, const Progress& progress) {
  if (options.source_operand) number_operands(joined);
  CleanOptions cleaning;
  cleaning.winding_level = winding_level;
  cleaning.merge_flat = options.merge_flat;
  cleaning.coordinate = options.coordinate;
  try {
    return clean_region(joined.mesh, cleaning, chooser, progress);
  } catch (const GoalError& error) {
    if (std::find(empty_region_kinds.begin(), empty_region_kinds.end(), error.kind()) ==
        empty_region_kinds.end())
      throw;
  }
  CleanResult empty;
  empty.mesh.vertex_columns = joined.mesh.vertex_columns.select({});
  empty.mesh.face_columns = joined.mesh.face_columns.select({});
  empty.removed_faces = joined.mesh.faces.size();
  empty.changed = true;
  return empty;
}

}  // namespace

BooleanResult boolean(BooleanOperation operation, const std::vector<Operand>& operands,
                      const BooleanOptions& options, const Progress& progress) {
  JoinedOperands joined = join_operands(operation, operands);
  BooleanResult result;
  if (joined.mesh.faces.empty()) {
    result.mesh = std::move(joined.mesh);
    return result;
  }
  const bool intersects = operation == BooleanOperation::intersect;
  std::vector<char> encloses(operands.size(), 1);
  const SolidChooser chooser(operation, operands, joined, encloses);
  try {
    static_cast<CleanResult&>(result) = clean_joined(
        joined, chooser, intersects ? static_cast<int>(operands.size()) : 1, options, progress);
  } catch (const InputError&) {
    check_solids(operands);  // which names the operand
    throw;
  }
  for (std::size_t i = 0; i < operands.size(); ++i)
    if (!encloses[i] && !operands[i].mesh->faces.empty()) result.empty_operands.push_back(i);
  return result;
}

CleanResult cut_sheet(const Operand& sheet, const Operand& solid, SheetSide side,
                      const BooleanOptions& options, const Progress& progress) {
  check_solids({solid});
  JoinedOperands joined = join_operands(BooleanOperation::unite, {sheet, solid});
  if (joined.mesh.faces.empty()) return {.mesh = std::move(joined.mesh)};
  return clean_joined(joined, SheetChooser(side, joined), 1, options, progress);
}

}  // namespace transformesh

#include "transformesh/boolean.h"

#include <algorithm>
#include <array>
#include <deque>

#include "boolean/capped_sheet.h"
#include "boolean/operand_kinds.h"
#include "boolean/operands.h"
#include "boolean/selected_cells.h"
#include "clean/whole/clean_whole.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

constexpr const char* operand_column = "source_operand";

/// Kinds of errors of clean_region() that mean that the result is empty, before or after rounding.
constexpr std::array empty_region_kinds{ErrorKind::no_positive_winding, ErrorKind::no_such_level,
                                        ErrorKind::canceling_faces, ErrorKind::no_area,
                                        ErrorKind::thinner_than_rounding};

/// Returns which signs the winding numbers of an operand have, if it is the only operand and
/// cleaning it failed with an error of this kind.
WindingSigns signs_of_one(ErrorKind kind) {
  return {false, kind == ErrorKind::no_positive_winding};
}

/// Chooses the boundary of the region that a Boolean operation selects.
class SolidChooser : public PieceChooser {
 public:
  SolidChooser(BooleanOperation operation, const std::vector<Operand>& operands,
               const JoinedOperands& joined, std::vector<WindingSigns>& signs)
      : operation_(operation), operands_(operands), joined_(joined), signs_(signs) {}

  void mark_open(WeldedMesh& /*welded*/) const override {}
  bool is_level_set(const WeldedMesh& welded, const std::vector<Meeting>& meetings) const override;
  void choose(Arrangement& arrangement, std::vector<char>& kept) const override {
    signs_ = choose_selected(operation_, joined_, WindingAt(), arrangement, kept).signs;
  }

 private:
  BooleanOperation operation_;
  const std::vector<Operand>& operands_;
  const JoinedOperands& joined_;
  /// For each operand whether positive and negative winding numbers occur; set by choose().
  std::vector<WindingSigns>& signs_;
};

// Let w be the winding number of an operand at a point, and s the sum of the winding numbers of all
// operands. Returns true if s decides whether a point belongs to the result:
// - Union: if no w is negative anywhere, s >= 1 exactly in the union.
// - Intersection: if every w is 0 or 1 everywhere, s equals the number of operands exactly in the
// intersection.
// - Difference: subtracted operands are reversed. If the w of the first operand is 0 or 1, and no
//   other w was negative before the reversal, s >= 1 exactly in the difference.
bool SolidChooser::is_level_set(const WeldedMesh& welded,
                                const std::vector<Meeting>& meetings) const {
  const std::vector<OperandKind> kinds = find_operand_kinds(welded, meetings, joined_);
  const auto is_simple = [](OperandKind kind) { return kind == OperandKind::simple; };
  const auto is_unknown = [](OperandKind kind) { return kind == OperandKind::unknown; };
  const bool is_any_unknown = std::any_of(kinds.begin(), kinds.end(), is_unknown);
  if (is_any_unknown) check_solids(operands_);
  if (operands_.size() == 1) return true;
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

/// Chooses the pieces of a sheet, the first operand, inside or outside a solid. With `cap`, also
/// chooses the pieces of the solid that close the sheet.
class SheetChooser : public PieceChooser {
 public:
  SheetChooser(SheetSide side, bool cap, const JoinedOperands& joined)
      : side_(side), cap_(cap), joined_(joined) {}

  void mark_open(WeldedMesh& welded) const override {
    for (const Index face : welded.face_of)
      welded.open_component.push_back(joined_.operand_of[face] == 0 ? 0 : no_index);
  }
  bool is_level_set(const WeldedMesh& /*welded*/,
                    const std::vector<Meeting>& /*meetings*/) const override {
    return false;
  }
  void choose(Arrangement& arrangement, std::vector<char>& kept) const override {
    if (cap_) return choose_capped_sheet(side_, arrangement, kept);
    for (std::size_t p = 0; p < kept.size(); ++p)
      kept[p] = is_on_side(arrangement.pieces[p], side_) ? 1 : 0;
  }

 private:
  SheetSide side_;
  bool cap_;
  const JoinedOperands& joined_;
};

void number_operands(JoinedOperands& joined) {
  Mesh& mesh = joined.mesh;
  Column& column = mesh.face_columns.get(operand_column, Scalar::int32, mesh.faces.size());
  std::copy(joined.operand_of.begin(), joined.operand_of.end(), column.values.begin());
}

/// Returns an empty result: it has no vertices and faces, but the attributes (columns) of the
/// operands.
BooleanResult empty_result(const Mesh& joined) {
  BooleanResult empty;
  empty.mesh.vertex_columns = joined.vertex_columns.select({});
  empty.mesh.face_columns = joined.face_columns.select({});
  empty.removed_faces = joined.faces.size();
  empty.changed = true;
  return empty;
}

BooleanResult clean_joined(JoinedOperands& joined, const PieceChooser& chooser, int winding_level,
                           const BooleanOptions& options, const Progress& progress) {
  if (options.source_operand) number_operands(joined);
  CleanOptions cleaning;
  cleaning.winding_level = winding_level;
  cleaning.merge_flat = options.merge_flat;
  cleaning.coordinate = options.coordinate;
  try {
    return {clean_region(joined.mesh, cleaning, chooser, progress), {}};
  } catch (const GoalError& error) {
    if (std::find(empty_region_kinds.begin(), empty_region_kinds.end(), error.kind()) ==
        empty_region_kinds.end())
      throw;
    BooleanResult empty = empty_result(joined.mesh);
    empty.reason = error.kind();
    return empty;
  }
}

void note_operands(const std::vector<Operand>& operands, const std::vector<WindingSigns>& signs,
                   BooleanResult& result) {
  for (std::size_t i = 0; i < operands.size(); ++i) {
    if (signs[i].is_positive || operands[i].mesh->faces.empty()) continue;
    (signs[i].is_negative ? result.inside_out : result.canceling).push_back(i);
  }
}

}  // namespace

BooleanResult boolean(BooleanOperation operation, const std::vector<Operand>& operands,
                      const BooleanOptions& options, const Progress& progress) {
  std::deque<Mesh> rounded;
  const std::vector<Operand> solids = rounded_operands(operands, options.coordinate, rounded);
  JoinedOperands joined = join_operands(operation, solids);
  if (joined.mesh.faces.empty()) return empty_result(joined.mesh);
  const bool intersects = operation == BooleanOperation::intersect;
  std::vector<WindingSigns> signs(solids.size(), {true, false});
  const SolidChooser chooser(operation, solids, joined, signs);
  try {
    BooleanResult result = clean_joined(
        joined, chooser, intersects ? static_cast<int>(solids.size()) : 1, options, progress);
    if (solids.size() == 1 && result.reason) signs[0] = signs_of_one(*result.reason);
    note_operands(solids, signs, result);
    return result;
  } catch (const InputError&) {
    // If an operand is not closed or not oriented, throws an error that names it.
    check_solids(solids);
    throw;
  }
}

BooleanResult cut_sheet(const Operand& sheet, const Operand& solid, SheetSide side,
                        const BooleanOptions& options, const Progress& progress) {
  check_solids({solid});
  std::deque<Mesh> rounded;
  JoinedOperands joined = join_operands(
      BooleanOperation::unite, rounded_operands({sheet, solid}, options.coordinate, rounded));
  if (joined.mesh.faces.empty()) return empty_result(joined.mesh);
  return clean_joined(joined, SheetChooser(side, options.cap, joined), 1, options, progress);
}

}  // namespace transformesh

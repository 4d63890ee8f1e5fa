/// Chooses the result of a Boolean operation from an arrangement. The pieces divide space into
/// cells, and the operation selects cells by the winding numbers of all operands. The chosen pieces
/// have a selected cell on one side only. A ray finds the winding numbers in one cell of every
/// connected set of pieces. They change from a cell to its neighbor by the faces that contain the
/// pieces between both cells. Exact. Cost: O(n log n), for any number of operands. Deterministic.
/// Reference: Zhou, Grinspun, Zorin & Jacobson, "Mesh arrangements for solid geometry", ACM TOG
/// 35(4), 2016. Departure: if a connected set of pieces is inside a cell of another set, the cells
/// of both sets are not joined.
#pragma once

#include <functional>
#include <optional>

#include "boolean/operand_windings.h"
#include "boolean/operands.h"
#include "clean/arrange/arrange.h"

namespace transformesh {

/// Function that returns the winding number of a solid at a point. It returns nothing if the point
/// is too near to the surface. Used if the arrangement contains only a part of the solid. The
/// winding number must be 0 in front of all faces of the solid, and 1 behind them.
using WindingAt = std::function<std::optional<int>(const Vec3& point)>;

struct Selection {
  /// False if `first_at` returned nothing for a point where the winding number was needed.
  bool is_known = true;
  std::vector<WindingSigns> signs{};  ///< for each operand which signs of winding numbers occur
};

/// Implements PieceChooser::choose(). If `first_at` is set, the arrangement contains only a part of
/// the first operand, and `first_at` returns winding numbers of the whole first operand.
Selection choose_selected(BooleanOperation operation, const JoinedOperands& operands,
                          const WindingAt& first_at, Arrangement& arrangement,
                          std::vector<char>& kept);

}  // namespace transformesh

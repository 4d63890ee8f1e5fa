/// Chooses the pieces between the cells of space that a Boolean operation selects and the cells
/// that it does not select. A ray finds the winding numbers of all operands in one cell of every
/// connected set of pieces. The source faces of the pieces between two cells give the difference of
/// their winding numbers. Exact. Cost: O(n log n), for any number of operands. Deterministic.
/// Reference: Zhou, Grinspun, Zorin & Jacobson, "Mesh arrangements for solid geometry", ACM TOG
/// 35(4), 2016. Departure: cells of different connected sets of pieces are not joined.
#pragma once

#include <functional>
#include <optional>

#include "boolean/operand_windings.h"
#include "boolean/operands.h"
#include "clean/arrange/arrange.h"

namespace transformesh {

/// Returns the winding number of a solid at a point, if the arrangement contains only a part of the
/// solid. Returns nothing near the surface. The solid has winding number 0 in front of its faces
/// and 1 behind them.
using WindingAt = std::function<std::optional<int>(const Vec3& point)>;

struct Selection {
  /// False if `first_at` returned nothing for a point where the winding number was needed.
  bool is_known = true;
  std::vector<WindingSigns> signs{};  ///< signs of the winding numbers of each operand
};

/// Implements PieceChooser::choose(). If `first_at` is not null, the first operand is a part of a
/// solid, and `first_at` returns winding numbers of the whole solid.
Selection choose_selected(BooleanOperation operation, const JoinedOperands& operands,
                          const WindingAt& first_at, Arrangement& arrangement,
                          std::vector<char>& kept);

}  // namespace transformesh

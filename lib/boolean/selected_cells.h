/// Chooses the pieces between cells of space that a Boolean operation selects and cells that it
/// does not (Zhou et al. 2016). A ray finds the winding numbers of all operands in one cell of
/// every connected set of pieces. From cell to cell they change by the sources of the pieces
/// between them. Exact. Cost: O(n log n), whatever the number of operands. Deterministic.
#pragma once

#include <functional>
#include <optional>

#include "boolean/operand_windings.h"
#include "boolean/operands.h"
#include "clean/arrange/arrange.h"

namespace transformesh {

/// The winding number at a point of a solid of which the arrangement has a part only. Empty near
/// the surface. In front of faces of a solid that number is 0, and 1 behind them.
using WindingAt = std::function<std::optional<int>(const Vec3& point)>;

struct Selection {
  bool is_known = true;               ///< false if `first_at` did not tell a winding number
  std::vector<WindingSigns> signs{};  ///< per operand
};

/// Does what PieceChooser::choose() says. If `first_at` is given, the first operand is part of a
/// solid.
Selection choose_selected(BooleanOperation operation, const JoinedOperands& operands,
                          const WindingAt& first_at, Arrangement& arrangement,
                          std::vector<char>& kept);

}  // namespace transformesh

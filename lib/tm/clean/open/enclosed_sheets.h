/// The sheets of an open mesh that lie within its bodies, such as a wall that two bodies share and
/// that is given only once: with it winding numbers contradict each other, without it the skin
/// around both is closed.
///
/// The surfaces part space into cells. From the unbounded cell, where it is 0, the winding number
/// passes from cell to cell, nearest cells first. A sheet is enclosed where all of it contradicts
/// the cells on both of its sides, both are within the body, and no edge is left with a border by
/// its removal. So a sheet outside of bodies, or in a body with a hole, never is.
/// Cost: that of an arrangement for every round of removals, of which there is mostly one.
/// Deterministic.
#pragma once

#include <vector>

#include "tm/clean/arrange/arrange.h"

namespace transformesh {

/// Marks the faces of the arrangement's soup that belong to such sheets. Within the body is where
/// the winding number is >= level.
std::vector<char> find_enclosed_sheets(const Arrangement& arrangement, int level,
                                       const Progress& progress);

/// The soup without the marked faces.
Soup without_faces(const Soup& soup, const std::vector<char>& marks);

}  // namespace transformesh

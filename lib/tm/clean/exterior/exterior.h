/// Which pieces of an arrangement bound the region of points p with w(p) >= level, w being the
/// winding number of the whole mesh (paper 2, 3.2 and 4.5). A piece is kept exactly where its front
/// has w < level and its back w >= level.
///
/// `grow`: pieces between intersection curves form patches; a ray fixes w at one seed of each
/// connected set of patches, and w follows from patch to patch around the curves by the angular
/// order of the pieces there. `static_test`: every piece gets a ray of its own; the slow reference.
/// On an open mesh w is not constant on patches. There every connected set of patches grows from a
/// piece that is exterior once borders are closed (paper 4.6), through kept patches first.
/// Exact; deterministic. Throws GoalError where no piece is kept.
#pragma once

#include <vector>

#include "tm/clean/arrange/arrange.h"
#include "tm/clean/exterior/close_borders.h"
#include "tm/support/progress.h"

namespace transformesh {

enum class ExteriorMethod { grow, static_test };

struct Exterior {
  std::vector<char> kept;   ///< per piece
  std::size_t patches = 0;  ///< 0 for static_test
  std::size_t rays = 0;
};

/// The closure of a closed mesh is empty.
Exterior find_exterior(const Arrangement& arrangement, int level, ExteriorMethod method,
                       const BorderClosure& closure, const Progress& progress);

}  // namespace transformesh

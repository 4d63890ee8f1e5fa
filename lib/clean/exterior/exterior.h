/// Which pieces of an arrangement bound the region of points p with w(p) >= winding level, w being
/// the winding number of the whole mesh (paper 2 and 3.2). A piece is kept exactly where w <
/// winding level in front of it and w >= winding level behind it.
///
/// `grow` is the paper's region growing. A ray fixes w in front of one seed of each connected set
/// of patches (3.2.1); w is constant in front of a patch (3.2.2), and around an intersection curve
/// it follows from patch to patch by the angular order of the pieces (3.2.3). `static_test` is the
/// strategy of 4.5: every piece gets a ray of its own. It is slow, and serves as the reference.
/// In front of a patch of an open mesh w is not constant. There every connected set of patches
/// grows from a piece that is exterior once borders are closed (4.6), through kept patches first.
/// Exact; deterministic.
#pragma once

#include <vector>

#include "clean/arrange/arrange.h"
#include "clean/exterior/close_borders.h"
#include "clean/exterior/exterior_method.h"
#include "mesh/components.h"
#include "support/progress.h"

namespace transformesh {

struct Exterior {
  std::vector<char> kept;   ///< per piece
  std::size_t patches = 0;  ///< 0 if they were not computed
  std::size_t rays = 0;
};

/// The closure of a closed mesh is empty. Throws GoalError where no piece is kept.
Exterior find_exterior(const Arrangement& arrangement, int winding_level, ExteriorMethod method,
                       const BorderClosure& closure, const Progress& progress);

/// Keeps the outermost surface of a clean mesh (paper 2: inner components are usually not
/// considered): drops the components that bound cavities, and those that float in cavities. Returns
/// how many it dropped.
std::size_t drop_enclosed_components(Mesh& mesh);
/// The same, given the components.
std::size_t drop_enclosed_components(Mesh& mesh, const Components& components);

}  // namespace transformesh

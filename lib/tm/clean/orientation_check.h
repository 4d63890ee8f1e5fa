/// Whether a soup is the boundary of something: along every edge as many faces run one way as the
/// other. If not, whether what is missing is a border of an oriented open mesh.
#pragma once

#include <vector>

#include "tm/clean/soup.h"

namespace transformesh {

/// The borders of an open mesh as loops of points, each running along its faces; none if the mesh
/// is closed. Along an edge of many faces, one that does not pair up ends there. Throws InputError,
/// naming the place, where two or more faces are left over that run the same way.
std::vector<std::vector<Index>> find_border_loops(const Soup& soup, const Mesh& mesh);

}  // namespace transformesh

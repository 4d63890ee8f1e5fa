/// The exterior by the slow reference, the reason why nothing is exterior, and the enclosed
/// components of a clean mesh. (exterior_arrangement.h has the region growing of paper 3.2.)
#pragma once

#include <vector>

#include "clean/arrange/arrange.h"
#include "transformesh/components.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"

namespace transformesh {

/// The strategy of paper 4.5 for a closed mesh: a ray for each piece. Marks pieces with
/// w < winding level in front and w >= winding level behind. Exact; deterministic.
std::vector<char> find_exterior_by_rays(const Arrangement& arrangement, int winding_level,
                                        const Progress& progress);

/// The reason why no piece of a mesh is kept. `has_surface` says whether any piece is left if faces
/// that lie upon each other with opposite orientations cancel out.
Problem nothing_kept(const WeldedMesh& welded, bool has_surface, int winding_level);

/// Keeps the outermost surface of a clean mesh (paper 2: inner components are usually not
/// considered): drops the components that bound cavities, and those that float in cavities. Returns
/// how many it dropped.
std::size_t drop_enclosed_components(Mesh& mesh);
/// The same, given the components.
std::size_t drop_enclosed_components(Mesh& mesh, const Components& components);

}  // namespace transformesh

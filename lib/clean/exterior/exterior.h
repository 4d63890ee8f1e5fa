/// Computes the exterior by the slow reference method, explains why no face is exterior, and
/// removes enclosed components. (The region growing of paper 3.2 is in exterior_arrangement.h.)
#pragma once

#include <vector>

#include "clean/arrange/arrange.h"
#include "transformesh/components.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"

namespace transformesh {

/// Finds the exterior of a closed mesh by one ray per piece (paper 4.5). Returns 1 for pieces with
/// winding number w < winding level in front and w >= winding level behind. Exact; deterministic.
/// Cost: O(n log n) for n pieces if rays meet few faces.
std::vector<char> find_exterior_by_rays(const Arrangement& arrangement, int winding_level,
                                        const Progress& progress);

/// Returns the reason why no piece of a mesh is kept. `has_surface` is false if all pieces cancel
/// out, because coincident faces have opposite orientations.
Problem nothing_kept(const WeldedMesh& welded, bool has_surface, int winding_level);

/// Keeps the outermost surface of a clean mesh (paper 2: inner components are usually not
/// considered). Drops components that bound cavities, and components inside cavities. Returns the
/// number of dropped components.
std::size_t drop_enclosed_components(Mesh& mesh);
/// Does the same with the known components of `mesh`.
std::size_t drop_enclosed_components(Mesh& mesh, const Components& components);

}  // namespace transformesh

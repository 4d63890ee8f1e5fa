/// Finds the exterior of a mesh by the slow reference method, one ray per piece. Also explains an
/// empty result, and removes components inside other components. The fast method, the region
/// growing of paper 3.2, is in exterior_arrangement.h.
#pragma once

#include <vector>

#include "clean/arrange/arrange.h"
#include "transformesh/components.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"

namespace transformesh {

/// Finds the exterior pieces of an arranged closed mesh by one ray per piece (paper 4.5). Returns 1
/// for pieces with winding number w < winding level in front and w >= winding level behind. Exact;
/// deterministic. Cost: O(n log n) for n pieces if rays meet few faces.
std::vector<char> find_exterior_by_rays(const Arrangement& arrangement, int winding_level,
                                        const Progress& progress);

/// Returns the problem (kind and message) that explains why cleaning keeps no piece of a mesh.
/// `has_surface` is false if all faces coincide with faces of opposite orientation, so that they
/// cancel out.
Problem nothing_kept(const WeldedMesh& welded, bool has_surface, int winding_level);

/// Removes all components that are inside another component of a clean mesh: those that bound
/// cavities, and those inside cavities. (Paper 2: inner components are usually not considered.)
/// Returns the number of dropped components.
std::size_t drop_enclosed_components(Mesh& mesh);
/// Removes the same components; `components` are the components of `mesh`, if already computed.
std::size_t drop_enclosed_components(Mesh& mesh, const Components& components);

}  // namespace transformesh

/// Displaces a mesh whose edge lengths the caller has measured already.
#pragma once

#include <span>

#include "mesh/local_measures.h"
#include "transformesh/displace.h"

namespace transformesh {

/// Does what displace() does, given halfedge_lengths() of the mesh.
DisplaceResult displace_measured(Mesh& mesh, std::span<const Vec3> velocities,
                                 const DisplaceOptions& options, const HalfedgeLengths& edges);

}  // namespace transformesh

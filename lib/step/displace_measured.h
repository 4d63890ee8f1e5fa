/// Variant of displace() for callers that have already measured the edge lengths.
#pragma once

#include <span>

#include "mesh/local_measures.h"
#include "transformesh/displace.h"

namespace transformesh {

/// Does the same as displace(). `edges` must be halfedge_lengths() of the mesh.
DisplaceResult displace_measured(Mesh& mesh, std::span<const Vec3> velocities,
                                 const DisplaceOptions& options, const HalfedgeLengths& edges);

}  // namespace transformesh

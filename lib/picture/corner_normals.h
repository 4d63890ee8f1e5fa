/// Unit normals for shading, one per corner of each face: smooth, except at creases.
///
/// Faces around a vertex share a normal if they are connected by edges at which the surface bends
/// by at most the crease angle. That normal is the mean weighted by corner angles. Borders and
/// edges of more than two faces are creases. Faces without area have the normals of their
/// neighbors, or zero. Cost: O(n); deterministic.
#pragma once

#include <array>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

using CornerNormals = std::array<Eigen::Vector3f, 3>;

std::vector<CornerNormals> corner_normals(const Mesh& mesh, double crease_angle_deg);

}  // namespace transformesh

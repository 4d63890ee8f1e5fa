/// Unit normals for shading, one per corner of each face: smooth where the surface is, apart where
/// it has a crease. Around a vertex, faces share a normal (the mean weighted by corner angle) when
/// a chain of edges leads from one to the other across each of which the surface bends by at most
/// the crease angle. Borders and edges of more than two faces are creases.
/// Cost: O(n); deterministic. Faces without area have the normals of their neighbors, or zero.
#pragma once

#include <array>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

using CornerNormals = std::array<Eigen::Vector3f, 3>;

std::vector<CornerNormals> corner_normals(const Mesh& mesh, double crease_angle_deg);

}  // namespace transformesh

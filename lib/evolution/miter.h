/// Moves surfaces so that their planes stay planes and their sharp edges stay sharp.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Movements of the vertices that move the planes of the faces around each by 1 along their
/// normals, in the least-squares sense; exact where up to three planes meet. Where planes meet in
/// a sharp spike, at most 4 long. O(n).
/// Reference: Garland & Heckbert, "Surface simplification using quadric error metrics", SIGGRAPH
/// 1997, whose quadric of planes is minimized.
std::vector<Vec3> miter_directions(const Mesh& mesh);

}  // namespace transformesh

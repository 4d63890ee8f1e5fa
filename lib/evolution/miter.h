/// Directions for moving a surface so that planes stay planes and sharp edges stay sharp.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns a vector per vertex. A movement by this vector moves the planes of all faces at the
/// vertex by 1 along their normals, in the least-squares sense; exactly if at most three planes
/// meet. Vectors are at most 4 long, which is reached in sharp spikes. O(n).
/// Reference: Garland & Heckbert, "Surface simplification using quadric error metrics", SIGGRAPH
/// 1997, whose quadric of planes is minimized.
std::vector<Vec3> miter_directions(const Mesh& mesh);

}  // namespace transformesh

/// Shortens the movements of vertices so that the moved surface keeps a gap from an obstacle, which
/// is another surface.
///
/// A face may move in two cases. Either its longest movement is too short to bring it closer to the
/// obstacle than the gap. Or KeepOut::allows() its new position: the face keeps the gap there, and
/// no part of the obstacle lies in the prism that it sweeps. If a face may not move, movements of
/// its three vertices are halved. After five halvings, movements below the gap are set to zero. All
/// faces at changed vertices are tested again. As a result, the moved surface keeps the gap up to
/// rounding and has not passed through the obstacle. Directions of movements stay the same. A face
/// that was closer than the gap does not come closer.
///
/// Throws InputError if the mesh intersects the obstacle, and UsageError if the gap is not
/// positive. Cost: O(n log n) for n faces, in parallel; deterministic.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

struct LimitedMovements {
  std::size_t held_back = 0;  ///< vertices whose movement was shortened
  std::size_t near = 0;       ///< faces that are closer than the gap before they move
};

/// Returns position + movement, rounded to `coordinate`; the unrounded position if the movement is
/// zero.
Vec3 moved_position(const Vec3& position, const Vec3& movement, Scalar coordinate);

/// Shortens `movements`, one per vertex of the mesh.
LimitedMovements limit_movements(const Mesh& mesh, const KeepOutOptions& keep_out,
                                 Scalar coordinate, std::vector<Vec3>& movements);

}  // namespace transformesh

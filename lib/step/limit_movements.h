/// Shortens the movements of vertices so that a surface moved by them stays away from another.
///
/// A face may move where it can reach nothing nearer than the gap on any way, or where its place at
/// the end is no nearer than the gap (or than it was, where it was nearer) and nothing of the other
/// surface lies in the prism that it sweeps (keep_out.h). Where one may not, the movements of its
/// three vertices are halved, five times, and then are none; all that changed is asked again. So
/// the moved surface keeps the gap but for rounding, has not swept over any of the other surface,
/// and no vertex turns from its way. Movement along the other surface and away from it stays free.
///
/// Positions and movements are those of the vertices of `mesh`; the other columns are not used.
/// Throws InputError where the mesh meets the other surface, UsageError for a gap that is not
/// positive. Cost: O(n log n) for n faces; in parallel; deterministic.
#pragma once

#include <vector>

#include "geometry/keep_out_options.h"
#include "mesh/mesh.h"

namespace transformesh {

struct LimitedMovements {
  std::size_t held_back = 0;  ///< vertices whose movement was shortened
  std::size_t near = 0;       ///< faces that are nearer than the gap before they move
};

/// Where a vertex goes, as a number of that type. Without movement it stays.
Vec3 moved_position(const Vec3& position, const Vec3& movement, Scalar coordinate);

LimitedMovements limit_movements(const Mesh& mesh, const KeepOutOptions& keep_out,
                                 Scalar coordinate, std::vector<Vec3>& movements);

}  // namespace transformesh

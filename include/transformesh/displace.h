/// One explicit step of an evolution (paper 5.1.1, second step). Every vertex p moves by
/// time_step * velocity(p), but by at most alpha * e_avg(p) (paper 5.1.2). e_avg(p) is the mean
/// length of the edges at p.
///
/// Changes positions, and normals with them (surface_columns.h). Topology, order and other columns
/// stay. The result may intersect itself; clean() removes the self-intersections. A vertex without
/// edges does not move, because its limit alpha * e_avg is 0. Border edges count half in e_avg.
/// Velocities may have any finite size; a displacement that overflows is clamped. Throws GoalError
/// if most vertices would move so far that the spacing of their coordinates exceeds e_avg. Cost:
/// O(n), in parallel; deterministic.
#pragma once

#include <span>

#include "transformesh/errors.h"
#include "transformesh/measure.h"

namespace transformesh {

struct DisplaceOptions {
  double time_step = 1;  ///< factor of velocities; finite, either sign
  /// Largest movement of p as a fraction of e_avg(p); >= 0; the paper uses 0.1 to 0.3.
  double alpha = 0.2;
  /// An obstacle, and the distance that faces keep from it (limit_movements.h).
  KeepOutOptions keep_out = {};
  Scalar coordinate = Scalar::float64;  ///< new positions near `keep_out` are rounded to this type
};

/// Result of displace(). Lengths are in input units.
struct DisplaceResult {
  std::size_t moved = 0;          ///< vertices whose position changed
  std::size_t clamped = 0;        ///< vertices whose movement was limited by `alpha`
  std::size_t held_back = 0;      ///< vertices whose movement was limited by `keep_out`
  std::size_t near_keep_out = 0;  ///< faces nearer to the obstacle than the gap before the step
  double max_displacement = 0;    ///< largest movement of a vertex
  double rms_displacement = 0;    ///< root mean square movement of all vertices
  double max_clamp_share = 0;     ///< largest movement as a fraction of the vertex's own limit
  double mean_edge = 0;           ///< mean length of all edges before the step
  bool new_normals = false;       ///< normals were recomputed
};

/// Throws UsageError for options out of range, and if the number of velocities differs from that of
/// the vertices. Throws InputError, naming the vertex, for a velocity that is not finite, and if
/// the mesh intersects the obstacle.
DisplaceResult displace(Mesh& mesh, std::span<const Vec3> velocities,
                        const DisplaceOptions& options = {});

}  // namespace transformesh

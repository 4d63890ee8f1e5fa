/// One explicit step of an evolution (paper 5.1.1, second step): every vertex p moves by
/// time_step * velocity(p), but by no more than alpha * e_avg(p), e_avg(p) being the mean length of
/// the edges at p (paper 5.1.2).
///
/// Changes positions, and normals with them (surface_columns.h): topology, order and other columns
/// stay. The result may intersect itself; that is what clean() is for. A vertex without edges does
/// not move, because its clamp is 0. Edges on a border count half in e_avg. A velocity may have any
/// finite size: what overflows is clamped. Throws GoalError where most vertices go so far that
/// coordinates are farther apart than edges. Cost: O(n), in parallel; deterministic.
#pragma once

#include <span>

#include "transformesh/errors.h"
#include "transformesh/measure.h"

namespace transformesh {

struct DisplaceOptions {
  double time_step = 1;  ///< t; finite, either sign
  double alpha = 0.2;    ///< clamp as a fraction of e_avg(p); >= 0, the paper has 0.1 to 0.3
  KeepOutOptions keep_out = {};  ///< no face comes nearer to it than its gap (limit_movements.h)
  Scalar coordinate = Scalar::float64;  ///< positions near it are rounded to this type
};

/// Lengths in input units.
struct DisplaceResult {
  std::size_t moved = 0;          ///< vertices whose position changed
  std::size_t clamped = 0;        ///< vertices that wanted to go farther
  std::size_t held_back = 0;      ///< vertices that went less far because of `keep_out`
  std::size_t near_keep_out = 0;  ///< faces nearer to it than its gap before the step
  double max_displacement = 0;    ///< of any vertex
  double rms_displacement = 0;    ///< over all vertices
  double max_clamp_share = 0;     ///< largest movement as a fraction of the vertex's own clamp
  double mean_edge = 0;           ///< before the step, over all edges
  bool new_normals = false;       ///< there are normals, which were computed anew
};

/// Throws UsageError for options out of range and for a number of velocities other than that of the
/// vertices, InputError for a velocity that is not finite, with the vertex, and where the mesh
/// meets the surface to keep out of.
DisplaceResult displace(Mesh& mesh, std::span<const Vec3> velocities,
                        const DisplaceOptions& options = {});

}  // namespace transformesh

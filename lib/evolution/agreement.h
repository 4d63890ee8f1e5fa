/// Whether a mesh agrees with the target of a morph (paper 5.2) all over, and not merely at its
/// vertices: a bridge over a gap, or a thin sheet across a hole, may have all its vertices on the
/// target.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "evolution/loop/iteration.h"
#include "evolution/morph_remedy.h"
#include "step/target_query.h"

namespace transformesh {

/// The part of a target that a morph has to reach: the target without its cavities, which a surface
/// that evolves does not keep, and without components that float in them.
struct MorphGoal {
  /// Nothing for points, and for what is open, not manifold, or intersects itself.
  std::optional<Topology> topology;
  std::size_t left_out = 0;             ///< components of the target, 0 where there is no topology
  std::optional<Target> without_those;  ///< if there are any
  /// The surface or the points from which distances to the mesh are measured.
  const Target& of(const Target& target) const { return without_those ? *without_those : target; }
};
MorphGoal goal_of(const Target& target, const Progress& progress = Progress());

struct Agreement {
  std::string fault;  ///< why the mesh is not the target, with the place; empty where it is
  Mismatch mismatch;  ///< of a fault
  /// Largest distances there and back, over points all over the faces (compare.h), of a target
  /// with faces.
  std::optional<double> to_target, from_target;
};

/// Points all over the mesh have to be at most half its longest edge away from the target, which a
/// sharp edge can be cut off by; no point of the target may be missed by more than that edge, as a
/// thin tip can be; and the topology has to be that of the goal, where it has one. Of points
/// nothing can be said: no fault. Cost: that of farthest_from() with 40 000 samples.
Agreement agreement(const Mesh& mesh, const Topology& topology, const TargetQuery& query,
                    const MorphGoal& goal, const Progress& progress = Progress());

}  // namespace transformesh

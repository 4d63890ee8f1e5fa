/// Tests whether a mesh agrees with the target of a morph (paper 5.2) everywhere, and not only at
/// its vertices. A bridge over a gap, or a thin sheet across a hole, can have all its vertices on
/// the target.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "evolution/morph_remedy.h"
#include "step/target_query.h"
#include "transformesh/iteration.h"

namespace transformesh {

/// The part of a target that the surface of a morph must reach. Cavities, and components inside of
/// cavities, are left out, because cleaning removes them from the evolving surface.
struct MorphGoal {
  /// Topology of the part of the target that must be reached. Empty if the target has no faces, is
  /// not a closed manifold, or intersects itself.
  std::optional<Topology> topology;
  /// Number of target components that are left out, since they are in cavities; 0 if `topology` is
  /// empty.
  std::size_t left_out = 0;
  /// The target without the components that are left out. Empty if none are left out.
  std::optional<Target> without_those;
  /// Returns the part of the target from which distances to the mesh are measured.
  const Target& of(const Target& target) const { return without_those ? *without_those : target; }
};
/// Returns the part of the target that a morph to this target must reach.
MorphGoal goal_of(const Target& target, const Progress& progress = Progress());

struct Agreement {
  std::string fault;  ///< text: how and where the mesh differs from the target; empty if they agree
  Mismatch mismatch;  ///< details of the largest difference (morph_remedy.h)
  /// Largest distance of sample points of the mesh from the target, and of sample points of the
  /// goal from the mesh (compare.h). Empty if the target has no faces.
  std::optional<double> to_target, from_target;
};

/// Compares a mesh with a target. They agree under three conditions, where L is the longest edge of
/// the mesh. Points of the mesh are at most L / 2 away from the target, since edges that cut off a
/// sharp edge of the target can be that far away. Points of the goal are at most L away from the
/// mesh, since the mesh may lack the last piece of a thin tip. If the goal has a topology, the mesh
/// has the same topology. Returns no fault if the target has no faces. Cost: that of
/// farthest_from() with 40 000 samples.
Agreement agreement(const Mesh& mesh, const Topology& topology, const TargetQuery& query,
                    const MorphGoal& goal, const Progress& progress = Progress());

}  // namespace transformesh

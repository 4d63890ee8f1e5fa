/// Finds the cause if the surface of a morph disagrees with its target or has vanished. The target
/// counts as narrow only where local_thickness() finds a narrow gap or wall.
#pragma once

#include <string>

#include "step/target_query.h"
#include "support/empty_result_error.h"
#include "transformesh/errors.h"
#include "transformesh/morph.h"

namespace transformesh {

/// The largest disagreement of mesh and target.
struct Mismatch {
  Vec3 place = Vec3::Zero();  ///< point of mesh or target that is farthest from the other surface
  double distance = 0;        ///< distance of `place` from the other surface; input units
  bool is_on_target = false;  ///< true if `place` is a point of the target
  double longest_edge = 0;    ///< length of the longest edge of the mesh, in input units
  /// True if mesh and target differ in the number of components or in the genus.
  bool is_of_topology = false;
  /// True if the target is a closed manifold without self-intersections.
  bool has_clean_target = true;
  /// True if the mesh does not have shorter edges at narrow places of the target.
  bool has_uniform_edges = true;
};

/// Returns a problem of kind target_not_solid, edges_too_long, uniform_edges_too_long or
/// source_apart. If a narrow place of the target is the cause, the sentence names it; otherwise the
/// sentence is empty. `lengths` are the width of the narrow place, if any, and the longest edge.
/// The target must have faces. Cost: at most that of local_thickness().
Problem cause_of(const TargetQuery& target, const Mismatch& found);

/// Returns the reason why a surface vanished whose longest edge had this length. The target counts
/// as narrow if at least half of its vertices are at narrow places. Returns
/// ErrorKind::surface_vanished if no reason is found.
Problem cause_of_vanishing(const Target& target, double longest_edge, bool has_uniform_edges);

/// Returns a text such as " at (1, 2, 3)", with four digits per coordinate.
std::string at_place(const Vec3& place);

}  // namespace transformesh

/// Finds out why the surface of a morph does not agree with its target or has vanished. The answer
/// follows from measures of the target: it counts as narrow only if a gap or wall is.
#pragma once

#include <string>

#include "step/target_query.h"
#include "support/empty_result_error.h"
#include "transformesh/errors.h"
#include "transformesh/morph.h"

namespace transformesh {

/// The largest disagreement of mesh and target.
struct Mismatch {
  Vec3 place = Vec3::Zero();      ///< the point of one that is farthest from the other
  double distance = 0;            ///< how far; input units
  double longest_edge = 0;        ///< of the mesh
  bool is_of_topology = false;    ///< components or genus differ
  bool has_clean_target = true;   ///< a closed manifold that does not intersect itself
  bool has_uniform_edges = true;  ///< edges are not shorter at narrow places of the target
};

/// Returns one of the kinds target_not_solid, edges_too_long, uniform_edges_too_long and
/// source_apart. The sentence names the narrowest place of the target, and is empty if that is not
/// the cause. The lengths are its width, if any, and the longest edge of the mesh. For a target
/// with faces. Cost: that of local_thickness() at most.
Problem cause_of(const TargetQuery& target, const Mismatch& found);

/// Returns the cause for a surface that vanished while its longest edges were so long, or
/// surface_vanished. The target counts as narrow if it is at half of its vertices.
Problem cause_of_vanishing(const Target& target, double longest_edge, bool has_uniform_edges);

/// " at (1, 2, 3)", with four digits.
std::string at_place(const Vec3& place);

}  // namespace transformesh

/// Chooses a remedy for a morph whose surface does not agree with its target or has vanished. The
/// choice follows from measures of the target: it counts as narrow only if a gap or wall is.
#pragma once

#include <limits>
#include <string>
#include <utility>

#include "step/target_query.h"
#include "support/empty_result_error.h"

namespace transformesh {

enum class RemedyKind {
  none,
  clean_target,            ///< it is open, not manifold, or intersects itself
  edges_at_narrow_places,  ///< shorter ones where the target is narrow
  larger_source,           ///< one that overlaps all of the target
  shorter_edges
};

struct MorphRemedy {
  RemedyKind kind = RemedyKind::none;
  double edge = 0;  ///< the longest one, input units
  /// Width of the narrowest gap or wall, and its place; set for `edges_at_narrow_places` only.
  double width = std::numeric_limits<double>::infinity();
  Vec3 place = Vec3::Zero();
};

/// The largest disagreement of mesh and target.
struct Mismatch {
  Vec3 place = Vec3::Zero();     ///< the point of one that is farthest from the other
  double distance = 0;           ///< how far; input units
  double longest_edge = 0;       ///< of the mesh
  bool is_of_topology = false;   ///< components or genus differ
  bool has_clean_target = true;  ///< a closed manifold that does not intersect itself
};

/// For a target with faces. Cost: that of local_thickness() at most.
MorphRemedy remedy_for(const TargetQuery& target, const Mismatch& found);

/// For a surface that vanished while its longest edges were so long. The target counts as narrow if
/// it is at half of its vertices.
MorphRemedy remedy_for_vanished(const Target& target, double longest_edge);

/// " at (1, 2, 3)", with four digits.
std::string at_place(const Vec3& place);

/// "the target is 0.02 wide at (1, 2, 3), and edges are up to 0.05 long"; empty for other
/// kinds.
std::string reason_of(const MorphRemedy& remedy);

/// The surface of a morph has vanished.
struct VanishedError : EmptyResultError {
  VanishedError(const std::string& what, MorphRemedy what_mends)
      : EmptyResultError(what), remedy(std::move(what_mends)) {}
  MorphRemedy remedy;
};

}  // namespace transformesh

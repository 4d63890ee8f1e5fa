/// Removes faces that are thinner than a few spacings of their coordinates.
#pragma once

#include "tm/remesh/halfedges/vertex_role.h"

namespace transformesh {

/// A sliver is a face whose height is at most this many spacings of its largest coordinate. Its
/// computed normal is mostly rounding error.
inline constexpr double sliver_spacings = 4;

bool is_sliver(const EditableMesh& mesh, Index face);

struct Slivers {
  std::size_t degenerate = 0;    ///< faces lower than a thousandth of their longest edges
  std::size_t kept = 0;          ///< of these, slivers
  std::size_t without_area = 0;  ///< of these, faces whose corners lie on one line, exactly
  Vec3 place = Vec3::Zero();     ///< a corner of the first sliver
};
Slivers count_slivers(const EditableMesh& mesh);

/// Collapses the shortest edge of a sliver if that edge is as short, otherwise flips its longest
/// edge. The surface moves by the height of the sliver; every step is tested exactly
/// (exact_guard.h), so no self-intersection is added. Slivers are kept where both steps would add
/// one or would change the topology. Marks of features are not maintained. Returns the number of
/// steps.
std::size_t remove_slivers(EditableMesh& mesh, const VertexRoles& roles);

}  // namespace transformesh

/// Removes triangles that have nearly no area.
#pragma once

#include "tm/remesh/operations/collapse.h"
#include "tm/remesh/operations/flip.h"

namespace transformesh {

/// A triangle counts as degenerate when its height is below a thousandth of its longest edge: one
/// with a short edge (needle) loses that edge, one without (cap) has its longest edge flipped.
/// Returns how many are left, where both were refused.
std::size_t remove_degenerate_faces(EditableMesh& mesh, EmbeddingGuard& guard,
                                    const VertexRoles& roles, double max_edge);

/// The faces that count as degenerate, ascending.
std::vector<Index> degenerate_faces(const EditableMesh& mesh);

}  // namespace transformesh

/// Removes degenerate triangles, which have nearly no area.
#pragma once

#include <algorithm>

#include "remesh/operations/collapse.h"
#include "remesh/operations/flip.h"

namespace transformesh {

/// A triangle is degenerate if its height is at most this share of its longest edge. With a larger
/// share, more of the surface changes; with a smaller share, normals of the remaining thin faces
/// are less reliable.
inline constexpr double least_height = 1e-3;

/// The measures of a face that decide whether it is degenerate.
struct FaceShape {
  double doubled_area_squared;
  double longer_squared;  ///< squared length of the longer one of two edges
  double third_squared;   ///< squared length of the third edge

  FaceShape(const EditableMesh& mesh, Index face) {
    const Vec3& a = mesh.position(mesh.source(3 * face));
    const Vec3 ab = mesh.position(mesh.source(3 * face + 1)) - a;
    const Vec3 ac = mesh.position(mesh.source(3 * face + 2)) - a;
    doubled_area_squared = ab.cross(ac).squaredNorm();
    longer_squared = std::max(ab.squaredNorm(), ac.squaredNorm());
    third_squared = (ac - ab).squaredNorm();
  }
  /// Twice the area is the longest edge times the height.
  bool is_degenerate() const {
    const double longest = std::max(longer_squared, third_squared);
    return doubled_area_squared <= least_height * least_height * longest * longest;
  }
};

/// Removes degenerate triangles. The short edge of a needle is collapsed; the longest edge of a
/// cap, which has no short edge, is flipped. Returns the number of degenerate triangles that are
/// left because their collapse or flip was refused.
std::size_t remove_degenerate_faces(EditableMesh& mesh, EmbeddingGuard& guard,
                                    const VertexRoles& roles, const EdgeLimits& limits);

/// Returns the degenerate faces, ascending.
std::vector<Index> degenerate_faces(const EditableMesh& mesh);

}  // namespace transformesh

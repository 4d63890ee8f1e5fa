/// Closes both sides of a slit by two copies of one patch (hole_patch.h, not faired), which are
/// moved apart. One copy is reversed. Vertices on the loop move as in SlitSide::drawn_back, inner
/// vertices by the mean of these movements. Two separately computed patches would intersect each
/// other if the loop is wide and uneven. Cost: that of the patch, and O(faces around the loop).
/// Deterministic.
#pragma once

#include <optional>

#include "fill/hole_patch.h"
#include "fill/slit.h"
#include "mesh/triangle.h"

namespace transformesh {

/// Returns a patch for the left side, whose reverse fits the right side. Call before the mesh is
/// slit. New points are indexed after the vertices of the mesh. Returns nothing if there is no
/// patch, or if each patch has an edge that already exists on a side.
std::optional<HolePatch> patch_of_slit(const Mesh& mesh, const std::vector<Index>& loop,
                                       const SlitSides& sides, const HalfedgeStars& stars);

/// Positions of the vertices of one side after it is moved away from the slit.
struct DrawnSide {
  std::vector<Vec3> loop;
  std::vector<Vec3> within;  ///< positions of the patch vertices that are not on the loop
};

struct ClosedSlit {
  /// Faces of the left patch; their indices number the loop vertices first, then the inner
  /// vertices.
  std::vector<Face> faces;
  DrawnSide left, right;
  std::vector<Triangle> left_patch() const;
  std::vector<Triangle> right_patch() const;  ///< reversed triangles of the right side
};

/// Computes the patches that close_slit() will add. Call before the mesh is slit.
ClosedSlit drawn_apart(const Mesh& mesh, const std::vector<Index>& loop, const SlitSides& sides,
                       const HolePatch& patch, Scalar coordinate);

/// Slits the mesh and closes the slit. New vertices have columns as documented in fill.h; the
/// caller adds rows to face columns.
void close_slit(Mesh& mesh, const std::vector<Index>& loop, const SlitSides& sides,
                const HolePatch& patch, const ClosedSlit& slit);

}  // namespace transformesh

/// Closes both sides of a slit (slit.h) by two copies of one patch (hole_patch.h, plain or
/// refined), which are moved apart. One copy is reversed. Patch vertices on the loop move to
/// SlitSide::drawn_back, and the other patch vertices move by the mean of these movements. The
/// reason for using one patch: two separately computed patches would intersect each other if the
/// loop is wide and uneven. Cost: that of the patch, and O(faces around the loop). Deterministic.
#pragma once

#include <optional>

#include "fill/hole_patch.h"
#include "fill/slit.h"
#include "mesh/triangle.h"

namespace transformesh {

/// Returns a patch for the left side, whose reverse fits the right side. Call this before
/// slit_along(). The first additional point has the index after the last vertex of the mesh.
/// Returns nothing if there is no patch, or if each patch has an inner edge that already exists on
/// a side.
std::optional<HolePatch> patch_of_slit(const Mesh& mesh, const std::vector<Index>& loop,
                                       const SlitSides& sides, const HalfedgeStars& stars);

/// Positions of the patch vertices of one side after they are moved away from the slit. `loop` has
/// the vertices on the loop.
struct DrawnSide {
  std::vector<Vec3> loop;
  std::vector<Vec3> within;  ///< positions of the patch vertices that are not on the loop
};

struct ClosedSlit {
  /// Faces of the left patch. Corner indices number the vertices of the loop first, then the other
  /// patch vertices.
  std::vector<Face> faces;
  DrawnSide left, right;
  std::vector<Triangle> left_patch() const;
  std::vector<Triangle> right_patch() const;  ///< reversed triangles of the right side
};

/// Computes the positions of both patches that close_slit() will add, and changes nothing. Call
/// this before slit_along().
ClosedSlit drawn_apart(const Mesh& mesh, const std::vector<Index>& loop, const SlitSides& sides,
                       const HolePatch& patch, Scalar coordinate);

/// Cuts the mesh open by slit_along(), and closes both sides. New vertices have columns as
/// documented in fill.h; the caller adds rows to face columns.
void close_slit(Mesh& mesh, const std::vector<Index>& loop, const SlitSides& sides,
                const HolePatch& patch, const ClosedSlit& slit);

}  // namespace transformesh

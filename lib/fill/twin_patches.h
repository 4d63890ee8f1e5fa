/// Closes both sides of a slit by the same patch (hole_patch.h, not faired), seen from either side
/// and drawn apart: its border as the slit says, what is within it along the mean of that. Two
/// patches of their own would pass through each other where the loop is wide and uneven.
/// Cost: that of the patch, and O(faces around the loop). Deterministic.
#pragma once

#include <optional>

#include "fill/hole_patch.h"
#include "fill/slit.h"
#include "mesh/triangle.h"

namespace transformesh {

/// A patch for the left side, and so for the right one, before the mesh is slit. Its new points are
/// the vertices behind those of the mesh. Nothing where none is found, or where each has an edge
/// that a side has already.
std::optional<HolePatch> patch_of_slit(const Mesh& mesh, const std::vector<Index>& loop,
                                       const SlitSides& sides, const HalfedgeStars& stars);

/// Positions of the vertices of one side after it is drawn back from the other.
struct DrawnSide {
  std::vector<Vec3> loop;
  std::vector<Vec3> within;  ///< those of the patch that are not on the loop
};

struct ClosedSlit {
  std::vector<Face> faces;  ///< of the left patch: corners by their place in the loop, then within
  DrawnSide left, right;
  std::vector<Triangle> left_patch() const;
  std::vector<Triangle> right_patch() const;  ///< looks the other way
};

/// The patches as close_slit() makes them. The mesh is not slit yet.
ClosedSlit drawn_apart(const Mesh& mesh, const std::vector<Index>& loop, const SlitSides& sides,
                       const HolePatch& patch, Scalar coordinate);

/// Slits the mesh and closes it. New vertices have columns as documented in fill.h; those of faces
/// are the caller's.
void close_slit(Mesh& mesh, const std::vector<Index>& loop, const SlitSides& sides,
                const HolePatch& patch, const ClosedSlit& slit);

}  // namespace transformesh

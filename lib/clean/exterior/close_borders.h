/// Closes the borders of an open mesh for the sake of rays (paper 4.6), by triangle fans from an
/// added point to every border edge. They only help to find what is exterior, and are never part of
/// a result.
///
/// The centroid of the border suits a body with holes. Of a sheet it may lie in front of all faces,
/// which then all look interior. So the borders of a component that is a sheet rather than a body
/// are closed by a point far behind it, on the side to which its normals do not point. A component
/// is a sheet where the area vector of its faces is at least a third of their area, and the fans
/// from the centroids enclose hardly any volume. A sheet bounds nothing but what it meets: its
/// faces count for no other component. Cost: O(n log n). Deterministic.
#pragma once

#include <vector>

#include "clean/intersect/welded_mesh.h"

namespace transformesh {

struct BorderClosure {
  std::vector<Triangle> triangles;  ///< with the faces of the mesh they make a closed surface
  std::vector<Index> face_of;       ///< of each triangle: a welded face of what it closes
  std::vector<char> in_sheet;       ///< per welded face

  bool empty() const { return triangles.empty(); }
};

/// `border_loops` are the borders as loops of points, each in the direction of its faces. Without
/// loops the closure is empty.
BorderClosure close_borders(const WeldedMesh& welded,
                            const std::vector<std::vector<Index>>& border_loops);

}  // namespace transformesh

/// Closes the borders of an open mesh for the sake of rays (paper 4.6): fans from an added point to
/// every border edge. They only help to find what is exterior, and are never part of a result.
///
/// The paper puts the added point in the middle of the border. That suits a body with holes. On a
/// sheet it may lie in front of all faces, which then all look interior; so the borders of a
/// component that is rather a sheet than a body are closed by a point far behind it. A sheet is
/// here what its borders span at least a third of, and the middle fans do not close into a body
/// looking outwards. Orientation decides: behind is where the normals come from.
/// A sheet bounds nothing but what it meets: elsewhere its faces are not to be counted.
/// Cost: O(n). Deterministic.
#pragma once

#include <vector>

#include "tm/clean/intersect/soup.h"

namespace transformesh {

struct BorderClosure {
  std::vector<Triangle> triangles;  ///< together with the soup closed along every edge
  std::vector<Index> face_of;       ///< of each triangle: a soup face of what it closes
  std::vector<char> in_sheet;       ///< per soup face

  bool empty() const { return triangles.empty(); }
};

/// `border_loops` are the borders as loops of points, each running along its faces. Without any,
/// the closure is empty.
BorderClosure close_borders(const Soup& soup, const std::vector<std::vector<Index>>& border_loops);

}  // namespace transformesh

/// Selects the component of a mesh around a point. Among the components that contain the point, the
/// closest one is selected, which is the innermost of nested components. If no component contains
/// the point, the closest of all is selected.
///
/// A component contains the point if its winding number at the point, rounded to an integer, is not
/// 0. It also contains points on its surface, up to rounding. This is exact for closed components
/// of any orientation. It tolerates holes that are small when viewed from the point; open sheets
/// contain no point. Reference: Jacobson, Kavan & Sorkine-Hornung, "Robust inside-outside
/// segmentation using generalized winding numbers", ACM TOG 32(4), 2013.
///
/// Components are connected by vertex indices. Deterministic; ties are broken by the lowest
/// component. Cost: O(n).
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

struct ComponentAround {
  /// For each face, whether it belongs to the component; for select_faces().
  std::vector<bool> faces;
  bool contains_point = false;
  double distance = 0;  ///< distance of the point from the surface, in input units
};

/// Selects the component around the point. Throws InputError if the mesh has no faces.
ComponentAround component_around(const Mesh& mesh, const Vec3& point);

}  // namespace transformesh

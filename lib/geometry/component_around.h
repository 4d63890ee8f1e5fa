/// The component of a mesh that a point lies in: of those that contain the point the closest, which
/// of nested ones is the innermost; where none contains it, the closest of all.
/// A component contains the point where its winding number there rounds to another number than 0:
/// that is exact for closed ones, of any orientation, forgives holes that are small from there, and
/// takes open sheets for what they are. What passes through the point, but for rounding, contains
/// it. Reference: Jacobson, Kavan & Sorkine-Hornung, "Robust inside-outside segmentation using
/// generalized winding numbers", ACM TOG 32(4), 2013.
///
/// Components hang together by vertex indices. Deterministic; of components as close as each other
/// the first. Cost: O(n).
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

struct ComponentAround {
  std::vector<bool> faces;  ///< which ones are of the component: for select_faces()
  bool contains_point = false;
  double distance = 0;  ///< from the point to the surface, in input units
};

/// Throws InputError for a mesh without faces.
ComponentAround component_around(const Mesh& mesh, const Vec3& point);

}  // namespace transformesh

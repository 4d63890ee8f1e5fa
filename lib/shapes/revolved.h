/// Cylinders and cones about the z axis, made of rings of vertices.
#pragma once

#include "transformesh/mesh.h"

namespace transformesh::shapes {

/// Returns a convex cylinder centered at the origin. Lengths are positive.
Mesh cylinder(double radius, double height, std::size_t faces);

/// Returns a convex cone with its tip upwards. The midpoint of its axis is the origin.
Mesh cone(double radius, double height, std::size_t faces);

}  // namespace transformesh::shapes

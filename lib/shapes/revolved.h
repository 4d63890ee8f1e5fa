/// Cylinders and cones about the z axis, made of rings of vertices.
#pragma once

#include "transformesh/mesh.h"

namespace transformesh::shapes {

/// Convex; its middle is the origin. Lengths are above 0.
Mesh cylinder(double radius, double height, std::size_t faces);

/// The tip is above; the middle of the axis is the origin.
Mesh cone(double radius, double height, std::size_t faces);

}  // namespace transformesh::shapes

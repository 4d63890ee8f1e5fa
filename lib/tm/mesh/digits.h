/// Whether coordinates have the digits that a mesh needs: far from the origin, or in floats,
/// corners that are close become one place, and bodies become flat.
#pragma once

#include <span>

#include "tm/mesh/mesh.h"

namespace transformesh {

/// From the size of a coordinate to the next larger number of that type, float64 or float32;
/// infinite where there is no larger double.
double spacing_at(double coordinate, Scalar type = Scalar::float64);
/// From the largest coordinate of any vertex.
double coordinate_spacing(const Mesh& mesh, Scalar type = Scalar::float64);

struct RoundingLoss {
  std::size_t collapsed = 0;  ///< faces of which two corners have become one place
  std::size_t turned = 0;     ///< others whose normal turned by more than 45 degrees
};

/// What the rounding of positions did to the faces. O(faces).
RoundingLoss rounding_loss(const Mesh& mesh, std::span<const Vec3> before);

}  // namespace transformesh

/// Distances of neighboring floating-point numbers at coordinates, and rounding to them. If they
/// are large compared with the edges, as far from the origin or in floats, close corners become one
/// position and bodies become flat.
#pragma once

#include <span>

#include "transformesh/mesh.h"

namespace transformesh {

/// From the size of a coordinate to the next larger number of that type, float64 or float32;
/// infinite where there is no larger double.
double spacing_at(double coordinate, Scalar type = Scalar::float64);
/// The spacing at the largest coordinate of any vertex.
double coordinate_spacing(const Mesh& mesh, Scalar type = Scalar::float64);

/// The spacing at the largest coordinate of a point; never zero.
double spacing_around(const Vec3& point, Scalar type);

/// Rounds to float and back. A pair of casts does not: g++ 12 with optimization drops it where it
/// handles two coordinates at once, and leaves doubles that no float can hold.
inline double round_to_single(double value) {
  const volatile auto single = static_cast<float>(value);  // volatile: the casts must happen
  return single;
}

/// The position as numbers of that type hold it.
inline Vec3 rounded_to(Vec3 position, Scalar type) {
  if (type == Scalar::float32)
    for (double& x : position) x = round_to_single(x);
  return position;
}

struct RoundingLoss {
  std::size_t collapsed = 0;  ///< faces of which two corners have become one place
  std::size_t turned = 0;     ///< others whose normal turned by more than 45 degrees
};

/// What the rounding of positions did to the faces. O(faces).
RoundingLoss rounding_loss(const Mesh& mesh, std::span<const Vec3> before);

}  // namespace transformesh

/// Spacing of floating-point numbers at coordinates, and rounding to them. The spacing is large
/// compared with the edges if a mesh is far from the origin or stored in floats. Then close corners
/// coincide after rounding, and bodies become flat.
#pragma once

#include <optional>
#include <span>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns the distance from |coordinate| to the next larger number of the type, float64 or
/// float32. Returns infinity if there is no larger number.
double spacing_at(double coordinate, Scalar type = Scalar::float64);
/// Returns the spacing at the largest coordinate of any vertex.
double coordinate_spacing(const Mesh& mesh, Scalar type = Scalar::float64);

/// Returns the spacing at the largest coordinate of a point; never zero.
double spacing_around(const Vec3& point, Scalar type);

/// Rounds to float and back. A cast to float and back is not enough: g++ 12 drops both casts when
/// it vectorizes two coordinates, and leaves doubles that no float can represent.
inline double round_to_single(double value) {
  // Volatile, so that the compiler does not remove the casts.
  const volatile auto single = static_cast<float>(value);
  return single;
}

/// Returns the position rounded to the type.
inline Vec3 rounded_to(Vec3 position, Scalar type) {
  if (type == Scalar::float32)
    for (double& x : position) x = round_to_single(x);
  return position;
}

/// Throws GoalError if a coordinate is too large for a float. O(n).
void check_float_range(const Mesh& mesh);

/// Rounds coordinates to a scalar type. Returns the number of faces that collapse. Throws GoalError
/// if most faces collapse or turn over, or as check_float_range() does. O(n).
std::size_t round_positions(Mesh& mesh, Scalar coordinate);

/// Returns the mesh with positions rounded to the type, as round_positions() does. Returns nothing
/// if no position changes. O(n).
std::optional<Mesh> rounded_mesh(const Mesh& mesh, Scalar coordinate);

struct RoundingLoss {
  std::size_t collapsed = 0;  ///< number of faces with two corners that coincide after rounding
  /// Faces that did not collapse, but whose normal turned by more than 45 degrees.
  std::size_t turned = 0;
};

/// Counts the faces that rounding damaged. `before` are the positions before rounding. O(faces).
RoundingLoss rounding_loss(const Mesh& mesh, std::span<const Vec3> before);

}  // namespace transformesh

#include "clean/intersect/face_directions.h"

#include <cmath>

#include "geometry/numbers/machine_epsilon.h"

namespace transformesh {
namespace {

/// Upper bound of the rounding error of a projected triangle's area. The area is the difference of
/// two products, and the bound is relative to the sum of their absolute values.
constexpr double area_error = 1e-15;
/// Squared cosine of 60 degrees, the largest angle between a face's normal and the axis directions
/// in `leans`. Each normal is within 54.7 degrees of some axis direction, so each face has an
/// entry. A choice: a smaller angle gives smaller intersection-free regions with simpler outlines.
constexpr double least_squared_cosine = 0.25;

}  // namespace

FaceDirections directions_of_face(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = b - a, v = c - a;
  const Vec3 left(u[1] * v[2], u[2] * v[0], u[0] * v[1]);
  const Vec3 right(u[2] * v[1], u[0] * v[2], u[1] * v[0]);
  const Vec3 area = left - right;
  const double least = least_squared_cosine * area.squaredNorm();
  FaceDirections directions;
  for (int axis = 0; axis < 3; ++axis) {
    const double error =
        area_error * (std::abs(left[axis]) + std::abs(right[axis])) + underflow_guard;
    const unsigned is_up = area[axis] > error ? 1 : 0, is_down = area[axis] < -error ? 1 : 0;
    const unsigned look = (is_up | is_down << 1) << (2 * axis);
    directions.looks |= static_cast<AxisDirections>(look);
    directions.leans |= static_cast<AxisDirections>(area[axis] * area[axis] > least ? look : 0);
  }
  return directions;
}

}  // namespace transformesh

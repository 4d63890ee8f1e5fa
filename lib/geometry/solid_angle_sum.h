/// Sum of the signed solid angles of triangles at one point, divided by 4 pi, with a bound of its
/// rounding error. Reference: van Oosterom & Strackee, "The solid angle of a plane triangle", IEEE
/// TBME 1983. Departure: angles are summed as a product of complex numbers, and whole turns are
/// counted. This needs one arctangent per sum and gives the bound.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/elementary/arctangent.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct BoundedWindingNumber {
  double number = 0;  ///< winding number; an integer up to rounding if the mesh is closed
  double error = 0;   ///< bound of the error of `number`; 1 or more if the point is on the surface

  /// True if rounded() is certainly the exact winding number. Never true on the surface, and rarely
  /// for a mesh that is not closed.
  bool is_decided() const { return error < 0.25 && std::abs(number - std::round(number)) <= error; }
  int rounded() const { return static_cast<int>(std::lround(number)); }
};

class SolidAngleSum {
 public:
  /// Starts a sum at `point`. All coordinates, also those of triangles added later, must be at most
  /// `largest` in absolute value. Then no product overflows.
  SolidAngleSum(const Vec3& point, double largest)
      : scale_(safe_scale(std::max(largest, point.cwiseAbs().maxCoeff()))),
        origin_(point * scale_) {}

  /// Returns the unit vector from the point to a position, or NaN if both are equal.
  Vec3 direction(const Vec3& position) const {
    const Vec3 offset = position * scale_ - origin_;
    return offset / offset.norm();
  }

  /// Adds the triangle whose corners are in these directions from the point. Half of its solid
  /// angle is the argument of the complex number (real, imaginary).
  void add(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double imaginary = a.dot(b.cross(c));
    const double real = 1 + a.dot(b) + b.dot(c) + c.dot(a);
    const double size = std::max(std::abs(real), std::abs(imaginary));
    // If the point is on an edge or vertex, the angle is undefined; if it is on the face, the sign
    // is uncertain. Add 1 to the error bound.
    if (!(size > part_error) || (real < 0 && std::abs(imaginary) <= part_error)) {
      error_ += 1;
      return;
    }
    const double inverse = 1 / size;
    error_ += part_error * inverse;
    turn(real * inverse, imaginary * inverse);
    if (++until_rescaled_ % 256 == 0) rescale();
  }

  BoundedWindingNumber result() const {
    return {turns_ + elementary::atan2(imaginary_, real_) / (2 * std::numbers::pi), error_};
  }

 private:
  /// Bound of the rounding error of the real and imaginary part of the complex number of a face.
  /// They result from unit vectors in fewer than 60 roundings of numbers up to 1.
  static constexpr double part_error = 1e-14;

  /// Returns a power of two as factor, such that numbers up to `largest` can be squared and added
  /// without overflow.
  static double safe_scale(double largest) {
    return largest > 0 ? std::ldexp(1.0, -std::clamp(std::ilogb(largest), -1000, 1000)) : 1;
  }

  /// Multiplies the product by a complex number, and counts a turn if the sum of the angles leaves
  /// (-pi, pi]. An angle is in [0, pi] if the imaginary part is at least 0.
  void turn(double other_real, double other_imaginary) {
    const bool was_up = imaginary_ >= 0;
    const bool adds_up = other_imaginary >= 0;
    const double real = real_ * other_real - imaginary_ * other_imaginary;
    const double imaginary = real_ * other_imaginary + imaginary_ * other_real;
    const bool is_up = imaginary >= 0;
    if (was_up == adds_up && was_up != is_up) turns_ += was_up ? 1 : -1;
    real_ = real;
    imaginary_ = imaginary;
  }
  void rescale() {
    const double size = std::max(std::abs(real_), std::abs(imaginary_));
    real_ /= size;
    imaginary_ /= size;
  }

  double scale_;
  Vec3 origin_;
  double real_ = 1;
  double imaginary_ = 0;
  int turns_ = 0;
  double error_ = 0;
  int until_rescaled_ = 0;
};

}  // namespace transformesh

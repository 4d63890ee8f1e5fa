/// Measures of the quality of triangles, and of changes of normals.
#pragma once

#include <algorithm>
#include <cmath>

#include "mesh/triangle.h"

namespace transformesh {

/// Returns the area divided by the sum of the squared edge lengths, scaled to 1 for an equilateral
/// triangle. The roundness of a degenerate triangle is 0.
inline double roundness(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const double squares = ab.squaredNorm() + ac.squaredNorm() + (c - b).squaredNorm();
  return squares > 0 ? 3.4641016151377544 * ab.cross(ac).norm() / squares : 0;
}

/// Returns the cosine of the smallest angle, which is opposite the shortest edge. Smaller is
/// better.
inline double cosine_of_smallest_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double ab = (b - a).squaredNorm();
  const double bc = (c - b).squaredNorm();
  const double ca = (a - c).squaredNorm();
  // Minima and maxima select the shortest edge, because a branch would be unpredictable.
  const double lesser = std::min(ab, bc), greater = std::max(ab, bc);
  const double shortest = std::min(lesser, ca);
  const double product = std::max(lesser, std::min(greater, ca)) * std::max(greater, ca);
  return product > 0 ? (ab + bc + ca - 2 * shortest) / (2 * std::sqrt(product)) : 1;
}

/// True if a normal rotates by more than the angle with cosine `least_cosine`. `dot` is the product
/// of the normals before and after.
inline bool turns(double dot, double before_squared, double after_squared, double least_cosine) {
  if (dot <= 0) return true;
  return dot * dot < least_cosine * least_cosine * before_squared * after_squared;
}
inline bool turns(const Vec3& before, const Vec3& after, double least_cosine) {
  return turns(before.dot(after), before.squaredNorm(), after.squaredNorm(), least_cosine);
}

}  // namespace transformesh

/// The space between two parallel planes, for the certificates of the embedding guard.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/triangle.h"

namespace transformesh {

/// The space between two planes perpendicular to a direction.
class Slab {
 public:
  explicit Slab(Vec3 direction) : direction_(std::move(direction)) {}
  const Vec3& direction() const { return direction_; }
  void extend(const Triangle& triangle) {
    for (const Vec3& corner : triangle) {
      low_ = std::min(low_, direction_.dot(corner));
      high_ = std::max(high_, direction_.dot(corner));
    }
  }
  /// True if the triangle meets the slab; distances within rounding error count as contact.
  bool meets(const Triangle& triangle) const {
    const double a = direction_.dot(triangle[0]);
    const double b = direction_.dot(triangle[1]);
    const double c = direction_.dot(triangle[2]);
    const double margin = 1e-12 * (std::abs(low_) + std::abs(high_) + std::abs(a));
    return std::max({a, b, c}) >= low_ - margin && std::min({a, b, c}) <= high_ + margin;
  }

 private:
  Vec3 direction_;
  double low_ = HUGE_VAL;
  double high_ = -HUGE_VAL;
};

}  // namespace transformesh

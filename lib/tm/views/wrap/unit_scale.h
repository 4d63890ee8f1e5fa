/// Points brought to about unit size, for algorithms whose squares and products would overflow or
/// vanish elsewhere.
#pragma once

#include <span>
#include <vector>

#include "tm/mesh/mesh.h"

namespace transformesh {

/// A power of two, so that nothing is rounded on the way there, and points of any scale give the
/// same result.
class UnitScale {
 public:
  /// From the size of what is to become between 1 and 2. Throws InputError unless that is between
  /// 1e-290 and 1e290.
  explicit UnitScale(double size);

  double to_unit(double length) const;
  std::vector<Vec3> to_unit(std::span<const Vec3> points) const;
  double from_unit(double length) const;
  void from_unit(Mesh& mesh) const;

 private:
  int exponent_;
};

/// Of the points' bounding box; finite wherever a double can hold it.
double diagonal_of(std::span<const Vec3> points);

/// Throws InputError where a detail of that length is lost in the rounding of the points'
/// coordinates, or of the largest length.
void check_detail(std::span<const Vec3> points, double detail, double largest);

}  // namespace transformesh

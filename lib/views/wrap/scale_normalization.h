/// Steps that alpha wraps and Poisson wraps share. Points are normalized to about unit size,
/// because otherwise squares and products could overflow or underflow. The result is checked.
/// Internal to wrap.
#pragma once

#include <span>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Scales by a power of two. Scaling is thus exact, and results do not depend on the scale of the
/// points.
class ScaleNormalization {
 public:
  /// Maps `size` to [1, 2). Throws InputError unless `size` is between 1e-290 and 1e290.
  explicit ScaleNormalization(double size);

  double to_unit(double length) const;
  std::vector<Vec3> to_unit(std::span<const Vec3> points) const;
  double from_unit(double length) const;
  void from_unit(Mesh& mesh) const;

 private:
  int exponent_;
};

/// Returns the diagonal of the points' bounding box. Finite if a double can represent it.
double diagonal_of(std::span<const Vec3> points);

/// Returns for each point the index of the first point that is equal to it. Many equal points would
/// be too slow in CGAL's trees. O(n log n).
std::vector<std::size_t> first_equals(std::span<const Vec3> points);

/// Throws InputError if `detail` is lost in rounding, relative to the points' coordinates or to
/// `largest`.
void check_detail(std::span<const Vec3> points, double detail, double largest);

/// Reverses the orientation of a mesh that is inside out. Throws GoalError unless it is a closed,
/// oriented 2-manifold.
void check_wrap(Mesh& mesh);

}  // namespace transformesh

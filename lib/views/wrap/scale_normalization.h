/// Functions that alpha wraps and Poisson wraps have in common; used only in the folder `wrap`.
/// Points are scaled to about unit size, because otherwise squares and products could overflow or
/// underflow. The resulting surface is checked.
#pragma once

#include <span>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Scales points to about unit size by a power of two. Scaling is thus exact, and surfaces do not
/// depend on the scale of the points.
class ScaleNormalization {
 public:
  /// Chooses the power of two that scales `size` to [1, 2). Throws InputError unless `size` is
  /// between 1e-290 and 1e290.
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

/// Returns for each point the index of the first point that is equal to it. Duplicates are removed
/// with these indices, because CGAL's search trees are too slow for many equal points. O(n log n).
std::vector<std::size_t> first_equals(std::span<const Vec3> points);

/// Throws InputError if rounding errors could hide details of length `detail`. This is the case if
/// `detail` is less than 1e-12 times the largest coordinate of `points`, or less than 1e-12 times
/// `largest`.
void check_detail(std::span<const Vec3> points, double detail, double largest);

/// Reverses the orientation of the mesh if its volume is negative. Throws GoalError unless the mesh
/// is a closed, oriented 2-manifold with faces.
void check_wrap(Mesh& mesh);

}  // namespace transformesh

/// Steps that both ways of wrapping points share: points are brought to about unit size, because
/// squares and products would overflow or vanish elsewhere, and the result is checked. Internal to
/// wrap.
#pragma once

#include <span>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// A power of two, so that nothing is rounded on the way there, and points of any scale give the
/// same result.
class ScaleNormalization {
 public:
  /// Brings this size to between 1 and 2. Throws InputError unless it is between 1e-290 and 1e290.
  explicit ScaleNormalization(double size);

  double to_unit(double length) const;
  std::vector<Vec3> to_unit(std::span<const Vec3> points) const;
  double from_unit(double length) const;
  void from_unit(Mesh& mesh) const;

 private:
  int exponent_;
};

/// The diagonal of the points' bounding box; finite wherever a double can hold it.
double diagonal_of(std::span<const Vec3> points);

/// For each point the index of the first one that is equal, which is its own where there is none
/// before. Heaps of equal points are too much for CGAL's trees. O(n log n).
std::vector<std::size_t> first_equals(std::span<const Vec3> points);

/// Throws InputError where a detail of that length is lost in the rounding of the points'
/// coordinates, or of the largest length.
void check_detail(std::span<const Vec3> points, double detail, double largest);

/// Turns a mesh that is inside out. Throws GoalError unless it is a closed, oriented 2-manifold.
void check_wrap(Mesh& mesh);

}  // namespace transformesh

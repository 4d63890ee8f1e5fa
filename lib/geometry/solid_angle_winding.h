/// Winding numbers of an oriented mesh at points: how many times the surface encloses them, with
/// sign. The sum of the faces' signed solid angles over 4 pi.
/// Reference: van Oosterom & Strackee, "The solid angle of a plane triangle", IEEE TBME 1983. The
/// angles are summed as a product of complex numbers whose turns are counted, which needs no
/// arctangent and comes with a bound of the rounding error.
///
/// Vertices are the same when their positions are: what counts is the surface. Degenerate faces add
/// nothing. Floating point with a bound; deterministic for any number of threads.
/// Cost: O(faces) a point, about 10 ns a face; a mesh without faces winds around nothing.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace transformesh {

struct BoundedWindingNumber {
  double number = 0;  ///< an integer but for rounding where the mesh is closed
  double error = 0;   ///< at most this far from the exact sum; 1 or more on the surface

  /// Whether the exact number can only be `rounded()`. Never on the surface, and hardly ever for a
  /// mesh that is not closed.
  bool is_decided() const { return error < 0.25 && std::abs(number - std::round(number)) <= error; }
  int rounded() const { return static_cast<int>(std::lround(number)); }
};

class SolidAngleWinding {
 public:
  /// Keeps a reference to the mesh.
  explicit SolidAngleWinding(const Mesh& mesh);

  BoundedWindingNumber operator()(const Vec3& point) const;
  /// The same for many points, in parallel.
  std::vector<BoundedWindingNumber> operator()(std::span<const Vec3> points) const;

 private:
  BoundedWindingNumber sum(const Vec3& point, std::vector<Vec3>& directions) const;

  const Mesh* mesh_;
  double largest_coordinate_ = 0;
};

}  // namespace transformesh

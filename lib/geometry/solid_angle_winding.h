/// Winding numbers of an oriented mesh at points: the sum of the signed solid angles of the faces,
/// divided by 4 pi. Reference: van Oosterom & Strackee, "The solid angle of a plane triangle", IEEE
/// TBME 1983. Departure: angles are summed as a product of complex numbers, and whole turns are
/// counted. This needs one arctangent per point and gives a bound of the rounding error.
///
/// Vertices are equal if their positions are; only the surface matters. Degenerate faces contribute
/// nothing. Floating point with an error bound; deterministic for any number of threads. Cost:
/// O(faces) per point, about 10 ns per face. The winding number of a mesh without faces is 0.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

struct BoundedWindingNumber {
  double number = 0;  ///< an integer up to rounding if the mesh is closed
  double error = 0;   ///< bound of the distance from the exact sum; 1 or more on the surface

  /// True if rounded() is certainly the exact number. Never true on the surface, and rarely for a
  /// mesh that is not closed.
  bool is_decided() const { return error < 0.25 && std::abs(number - std::round(number)) <= error; }
  int rounded() const { return static_cast<int>(std::lround(number)); }
};

class SolidAngleWinding {
 public:
  /// Keeps a reference to the mesh.
  explicit SolidAngleWinding(const Mesh& mesh);

  BoundedWindingNumber operator()(const Vec3& point) const;
  /// Evaluates many points in parallel.
  std::vector<BoundedWindingNumber> operator()(std::span<const Vec3> points) const;

 private:
  BoundedWindingNumber sum(const Vec3& point, std::vector<Vec3>& directions) const;

  const Mesh* mesh_;
  double largest_coordinate_ = 0;
};

}  // namespace transformesh

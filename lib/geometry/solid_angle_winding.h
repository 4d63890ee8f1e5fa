/// Winding numbers of an oriented mesh at points: the sum of the signed solid angles of the faces,
/// divided by 4 pi. (WindingHierarchy needs far less time per point, if there are many points.)
///
/// Vertices are equal if their positions are; only the surface matters. Degenerate faces contribute
/// nothing. Floating point with an error bound; deterministic for any number of threads. Cost:
/// O(faces) per point, about 10 ns per face. The winding number of a mesh without faces is 0.
#pragma once

#include <span>
#include <vector>

#include "geometry/solid_angle_sum.h"
#include "transformesh/mesh.h"

namespace transformesh {

class SolidAngleWinding {
 public:
  /// Keeps a reference to the mesh.
  explicit SolidAngleWinding(const Mesh& mesh);

  BoundedWindingNumber operator()(const Vec3& point) const;
  /// Returns the winding numbers at many points, computed in parallel.
  std::vector<BoundedWindingNumber> operator()(std::span<const Vec3> points) const;

 private:
  BoundedWindingNumber sum(const Vec3& point, std::vector<Vec3>& directions) const;

  const Mesh* mesh_;
  double largest_coordinate_ = 0;
};

}  // namespace transformesh

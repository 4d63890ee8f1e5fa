/// Winding numbers of a closed oriented mesh at points, by counting the faces that a ray along the
/// x axis crosses. Exact predicates decide on each crossing, so the number is exact. The ray is
/// shifted by an infinitely small distance, so that it meets no edge and no corner.
/// (SolidAngleWinding sums solid angles instead: for any mesh, in floating point, in O(faces) per
/// point.)
///
/// Vertices are equal if their positions are. Faces without area are ignored. The mesh must be
/// closed; otherwise the number depends on the ray. Deterministic; thread-safe. Cost: O(n) to
/// build; O(log n) per point plus the faces along the ray.
#pragma once

#include <optional>

#include "geometry/numbers/predicates.h"
#include "geometry/search/bvh.h"
#include "transformesh/mesh.h"

namespace transformesh {

class RayCastWinding {
 public:
  /// Keeps a reference to the mesh.
  explicit RayCastWinding(const Mesh& mesh);

  /// Returns the winding number. Returns nothing if the point is on the surface.
  std::optional<int> operator()(const Vec3& point) const;

  /// True if the segment intersects a face. May also be true for a segment in the plane of a face.
  bool blocks(const Vec3& from, const Vec3& to) const;

 private:
  const Mesh* mesh_;
  BoxFrame frame_;
  Bvh bvh_;
};

}  // namespace transformesh

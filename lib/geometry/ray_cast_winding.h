/// Exact winding numbers of a closed oriented mesh at points, by counting the faces that an axis-
/// parallel ray crosses. Every crossing is decided by exact predicates. A ray that meets an edge, a
/// corner or a face seen edge-on is replaced by one in another direction. (SolidAngleWinding sums
/// solid angles instead: for any mesh, in O(faces) a point, in floating point.)
///
/// Vertices are the same if their positions are. Faces without area are ignored. The mesh must be
/// closed: otherwise the number depends on the ray. Deterministic; safe to call from several
/// threads at once. Cost: O(n) to build; O(log n) a point plus the faces along the ray.
#pragma once

#include <optional>

#include "geometry/numbers/predicates.h"
#include "geometry/search/bvh.h"
#include "mesh/mesh.h"

namespace transformesh {

class RayCastWinding {
 public:
  /// Keeps a reference to the mesh.
  explicit RayCastWinding(const Mesh& mesh);

  /// Nothing where the point is on the surface, or where no axis gives a ray that crosses faces in
  /// their insides only.
  std::optional<int> operator()(const Vec3& point) const;

  /// Whether the segment meets a face; sometimes true for one that lies in the plane of a face.
  bool blocks(const Vec3& from, const Vec3& to) const;

 private:
  std::optional<int> cast(const Vec3& point, int axis, bool towards_infinity) const;

  const Mesh* mesh_;
  BoxFrame frame_;
  Bvh bvh_;
};

}  // namespace transformesh

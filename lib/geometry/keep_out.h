/// Keeps surfaces away from a given surface by a gap. A change replaces a region of triangles by
/// new triangles. It is allowed if the new triangles keep the distance, and if no part of the given
/// surface is between both regions.
///
/// Distances of triangles are computed in floating point; intersections of triangles are decided
/// exactly. Hence an allowed region never intersects the surface, and is not closer than the gap,
/// up to rounding errors of 1e-14 of the coordinates. A region that is closer than the gap already
/// does not come closer. The surface may be open, and need not be oriented. Cost: O(n log n) to
/// build; a call takes time proportional to the number of faces within the gap of both regions.
/// Deterministic; thread-safe.
#pragma once

#include <span>
#include <vector>

#include "geometry/search/bvh.h"
#include "mesh/triangle.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Returns the least distance of two triangles; 0 if they intersect.
double distance_of(const Triangle& first, const Triangle& second);

class KeepOut {
 public:
  /// Keeps a reference to the surface. Throws UsageError unless the gap is positive and finite.
  explicit KeepOut(const KeepOutOptions& options);
  double gap() const { return gap_; }

  /// Returns the distance of the triangle from the surface, or `bound` if that is smaller.
  double distance(const Triangle& triangle, double bound) const;

  /// True if the triangles `made` may replace those in `replaced`. Both regions must have the same
  /// boundary, or the triangles `sides` must close the space between their boundaries, oriented
  /// like `made`. `sides` may be closer to the surface than the gap, but may not intersect it.
  bool allows(std::span<const Triangle> made, std::span<const Triangle> replaced,
              std::span<const Triangle> sides = {}) const;

  /// Returns the number of faces of the mesh that are closer to the surface than the gap. Throws
  /// InputError, with the location, if a face intersects the surface. Parallel.
  std::size_t count_near(const Mesh& mesh) const;

 private:
  using Triangles = std::span<const Triangle>;
  std::vector<Index> faces_near(Triangles made, Triangles replaced, Triangles sides) const;
  /// Returns the least distance of the triangles from the given faces of the surface, or `enough`
  /// if that is smaller.
  double least_distance(Triangles triangles, const std::vector<Index>& faces, double enough) const;
  bool is_apart(const Triangle& triangle, const Vec3& normal, Index face, double distance) const;
  bool meets(Triangles sides, const std::vector<Index>& faces) const;
  bool is_between(Triangles made, Triangles replaced, Triangles sides, Index face) const;

  const Mesh* surface_;
  double gap_;
  Bvh bvh_;
  std::vector<Vec3> normals_;  ///< unit normal of each face
};

}  // namespace transformesh

/// A surface that others are kept away from by a gap, whatever they are made of: a region of a
/// surface is replaced by another only where what is new stays as far away, and where nothing of
/// the surface lies between the two.
///
/// Distances are those of triangles, computed in floating point; whether triangles intersect is
/// decided exactly. So what is allowed never intersects it, and comes no nearer than the gap but
/// for rounding, 1e-14 of coordinates. Where a region is nearer than the gap already, it comes no
/// nearer than it is. The surface may be open, and need not be oriented. Cost: O(n log n) to build;
/// a call as much as there are faces within the gap of both regions. Deterministic; safe to call
/// from several threads at once.
#pragma once

#include <span>
#include <vector>

#include "geometry/keep_out_options.h"
#include "geometry/search/bvh.h"
#include "mesh/triangle.h"

namespace transformesh {

/// Least distance of two triangles; 0 where they meet.
double distance_of(const Triangle& first, const Triangle& second);

class KeepOut {
 public:
  /// Keeps a reference to the surface. Throws UsageError for a gap that is not a positive number.
  explicit KeepOut(const KeepOutOptions& options);
  double gap() const { return gap_; }

  /// The distance of the triangle from the surface where that is less than `bound`; else `bound`.
  double distance(const Triangle& triangle, double bound) const;

  /// Whether the triangles `made` may take the place of those in `replaced`. Both have the same
  /// rim, or `sides` close what is between their rims, oriented as `made`; these may be as near as
  /// they are.
  bool allows(std::span<const Triangle> made, std::span<const Triangle> replaced,
              std::span<const Triangle> sides = {}) const;

  /// How many faces of the mesh are nearer than the gap. Throws InputError where one meets the
  /// surface, with the place. In parallel.
  std::size_t count_near(const Mesh& mesh) const;

 private:
  using Triangles = std::span<const Triangle>;
  std::vector<Index> faces_near(Triangles made, Triangles replaced, Triangles sides) const;
  /// The least distance of any where that is less than `enough`; else that or more.
  double least_distance(Triangles triangles, const std::vector<Index>& faces, double enough) const;
  bool is_apart(const Triangle& triangle, const Vec3& normal, Index face, double distance) const;
  bool meets(Triangles sides, const std::vector<Index>& faces) const;
  bool is_between(Triangles made, Triangles replaced, Triangles sides, Index face) const;

  const Mesh* surface_;
  double gap_;
  Bvh bvh_;
  std::vector<Vec3> normals_;  ///< of unit length, per face
};

}  // namespace transformesh

/// Removes faces that are thinner than remeshing can treat.
#pragma once

#include "remesh/halfedges/vertex_role.h"

namespace transformesh {

/// A sliver is a degenerate face (degenerate.h) whose height is below one of two limits. The first
/// limit is 4 spacings of the largest coordinate: the normal of lower faces is mostly rounding
/// error. The second limit is a hundred-thousandth of `shortest`: lower faces are too thin for
/// edges of that length. `shortest` is the shortest edge length of remeshing, in input units.
///
/// The second limit was chosen by the number of degenerate faces that were left after 39,000 splits
/// on a union of nearly coplanar bodies. `share` is the limit as a share of the shortest edge: |
/// share | 0     | 1e-8  | 1e-7 | 1e-6 | 1e-5 | | left  | 2,689 | 1,432 | 654  | 148  | 0    |
class SliverTest {
 public:
  SliverTest(const EditableMesh& mesh, double shortest);
  bool operator()(Index face) const { return is_sliver(mesh_.triangle(face)); }
  bool is_sliver(const Triangle& triangle) const;
  /// Returns the largest height of a sliver with these corners.
  double thickness(const Triangle& triangle) const;
  /// Returns the largest height of any sliver of the mesh.
  double largest_thickness() const;

 private:
  const EditableMesh& mesh_;
  double least_;
};

struct Slivers {
  std::size_t degenerate = 0;    ///< number of degenerate faces
  std::size_t kept = 0;          ///< degenerate faces that are slivers
  std::size_t without_area = 0;  ///< slivers whose corners are exactly collinear
  Vec3 place = Vec3::Zero();     ///< a corner of the first sliver
};
Slivers count_slivers(const EditableMesh& mesh, const SliverTest& is_sliver);

/// Removes slivers. Collapses the shortest edge of a sliver if its length is at most the largest
/// height of slivers; otherwise flips its longest edge. The surface moves by the height of the
/// sliver. Every step is tested exactly (exact_guard.h), so that no self-intersection is added. A
/// sliver stays if both steps would add a self-intersection or change the topology. Features are
/// not maintained.
void remove_slivers(EditableMesh& mesh, const VertexRoles& roles, const SliverTest& is_sliver);

}  // namespace transformesh

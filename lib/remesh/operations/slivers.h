/// Removes faces that are thinner than remeshing can treat.
#pragma once

#include "remesh/halfedges/vertex_role.h"

namespace transformesh {

/// A sliver is a degenerate face (degenerate.h) whose height is at most 4 spacings of its largest
/// coordinate, where its normal is mostly rounding error, or at most a hundred-thousandth of the
/// shortest edge, which the edges of the result cannot show. `shortest` is that edge's length, in
/// input units.
///
/// The table gives the degenerate faces that were left after 39,000 splits on a union of
/// near-coplanar bodies, by the largest height of a sliver as a share of the shortest edge (about):
/// | share | 0     | 1e-8  | 1e-7 | 1e-6 | 1e-5 |
/// | left  | 2,689 | 1,432 | 654  | 148  | 0    |
class SliverTest {
 public:
  SliverTest(const EditableMesh& mesh, double shortest);
  bool operator()(Index face) const { return is_sliver(mesh_.triangle(face)); }
  bool is_sliver(const Triangle& triangle) const;
  /// The largest height of a sliver with these corners.
  double thickness(const Triangle& triangle) const;
  /// The largest height of any sliver of the mesh.
  double largest_thickness() const;

 private:
  const EditableMesh& mesh_;
  double least_;
};

struct Slivers {
  std::size_t degenerate = 0;    ///< degenerate faces
  std::size_t kept = 0;          ///< of these, slivers
  std::size_t without_area = 0;  ///< of these, faces whose corners lie on one line, exactly
  Vec3 place = Vec3::Zero();     ///< a corner of the first sliver
};
Slivers count_slivers(const EditableMesh& mesh, const SliverTest& is_sliver);

/// Collapses the shortest edge of a sliver if that edge is as short as slivers are thin, otherwise
/// flips its longest edge. The surface moves by the height of the sliver. Every step is tested
/// exactly (exact_guard.h), so no self-intersection is added. Slivers are kept where both steps
/// would add one or would change the topology. Marks of features are not maintained.
void remove_slivers(EditableMesh& mesh, const VertexRoles& roles, const SliverTest& is_sliver);

}  // namespace transformesh

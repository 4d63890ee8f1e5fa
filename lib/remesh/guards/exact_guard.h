/// Decides exactly whether triangles that replace faces would intersect the rest of the surface.
///
/// A new triangle may intersect a face only if one of the replaced faces already intersects that
/// face. Therefore no intersections are added to those of the input. The embedding guard is faster,
/// but counts distances within rounding errors as contact. The exact guard is for meshes with
/// features as thin as rounding errors. Intersection is defined by triangles_meet() (contacts.h).
/// Faces are stored in a bounding volume hierarchy that is built once; the parts of a divided face
/// become children of its leaf. Cost of a test: O(log n + number of near faces).
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "geometry/search/bvh.h"
#include "remesh/halfedges/editable_mesh.h"

namespace transformesh {

class ExactGuard {
 public:
  /// Keeps a reference to the mesh. Faces that move must be passed to divide(), unless they stay
  /// within `slack` of their former bounding box; input units.
  explicit ExactGuard(const EditableMesh& mesh, double slack = 0);

  /// True if the triangles `made` may replace the faces `replaced`. A new triangle may have no area
  /// only if one of `replaced` has none.
  bool allows(std::span<const Triangle> made, std::span<const Index> replaced) const;

  /// Calls visit(face) for each living face whose box touches the triangle's box, until a call
  /// returns false. Returns false if a call did.
  bool for_each_near(const Triangle& triangle, const std::function<bool(Index)>& visit) const;

  /// Stores `parts` as children of `face`, which they replace. One of `parts` may be `face` itself.
  /// Parts that were stored before are moved.
  void divide(Index face, std::span<const Index> parts);

 private:
  struct Node {
    FloatBox box;
    Index face = no_index;  ///< face of a leaf; else no_index
    Index parent = no_index;
    Index first_child = no_index;  ///< children have consecutive indices
    Index children = 0;
  };
  FloatBox box_of(const Triangle& triangle) const;
  void widen(Index node, const FloatBox& box);
  bool visit_below(Index root, const FloatBox& box, const std::function<bool(Index)>& visit) const;
  bool keeps_apart(const Triangle& triangle, std::span<const Index> replaced) const;

  const EditableMesh& mesh_;
  double slack_;
  BoxFrame frame_;
  std::vector<Node> nodes_;
  std::vector<Index> leaf_of_;  ///< leaf of each face
  Bvh bvh_;                     ///< tree of the initial nodes, one per face
  std::vector<Index> widened_;  ///< initial nodes that have outgrown their boxes in `bvh_`
};

}  // namespace transformesh

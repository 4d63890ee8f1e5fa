/// Decides exactly whether triangles that replace faces would intersect the rest of the surface.
///
/// A new triangle may meet a face only if one of the faces that it replaces met that face already.
/// Intersections of the input therefore stay where they are, and none is added. The embedding guard
/// is faster but counts contact within rounding error as contact; this guard serves meshes whose
/// features are thinner than that. Meeting is defined by triangles_meet() (contacts.h).
/// The faces are kept in a bounding volume hierarchy that is built once. The parts of a divided
/// face become children of its leaf. Cost of a test: O(log n + faces near).
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "geometry/search/bvh.h"
#include "remesh/halfedges/editable_mesh.h"

namespace transformesh {

class ExactGuard {
 public:
  /// Keeps a reference to the mesh. Faces that get another place have to be passed to divide(),
  /// unless they remain within `slack` of their former box, in input units.
  explicit ExactGuard(const EditableMesh& mesh, double slack = 0);

  /// Returns whether the triangles `made` may replace the faces `replaced`. No new triangle may be
  /// without area unless one of `replaced` is.
  bool allows(std::span<const Triangle> made, std::span<const Index> replaced) const;

  /// Calls visit(face) for each living face whose box touches that of the triangle until it returns
  /// false. Returns false if visit did.
  bool for_each_near(const Triangle& triangle, const std::function<bool(Index)>& visit) const;

  /// Registers that the faces `parts` lie in or near the place of `face`. One of them may be `face`
  /// itself; another one may have had a place before, which it loses.
  void divide(Index face, std::span<const Index> parts);

 private:
  struct Node {
    FloatBox box;
    Index face = no_index;  ///< of a leaf
    Index parent = no_index;
    Index first_child = no_index;  ///< children follow each other
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
  std::vector<Index> leaf_of_;  ///< per face
  Bvh bvh_;                     ///< of the nodes that faces had at first
  std::vector<Index> widened_;  ///< of these, nodes that have outgrown their boxes in it
};

}  // namespace transformesh

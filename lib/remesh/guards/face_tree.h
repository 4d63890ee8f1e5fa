/// Binary tree of the bounding boxes of a mesh's faces, which follows changes of the mesh. Faces
/// are sorted along a Hilbert curve when the tree is built, and keep their leaves; a changed face
/// enlarges or shrinks the boxes above its leaf. Cost: O(n log n) to build, O(log n) for a changed
/// face; a query takes O(log n) and the faces found, as long as faces stay near their first places.
/// Deterministic. Without the tree, the cells of VertexCells alone take 2.5 times as long to remesh
/// cow.off of CGAL adaptively, and 1.5 times as long for rotor.off. A Bvh does not follow changes.
///
/// The boxes of all faces at a vertex overlap there. If many faces share a vertex, the tree also
/// has boxes of the arcs that the faces cut out of a small sphere around the vertex
/// (simplex_links.h). Planes through the vertex then separate a triangle from most of the faces.
#pragma once

#include <optional>
#include <vector>

#include "geometry/search/simplex_links.h"
#include "remesh/guards/star_planes.h"
#include "remesh/halfedges/editable_mesh.h"

namespace transformesh {

class FaceTree {
 public:
  /// Keeps a reference to the mesh. Faces that are added later have no leaf.
  explicit FaceTree(const EditableMesh& mesh);

  /// Returns the number of faces that the vertex had when the tree was built.
  Index valence(Index vertex) const { return valences_[vertex]; }
  /// Call after a face was changed or removed.
  void update(Index face);

  /// Calls visit(face) for each face whose box may meet the box of these corners, until a call
  /// returns false. Returns false if a call did.
  template <class Visit>
  bool for_each_near(const Vec3& low, const Vec3& high, const Visit& visit) const {
    const FloatBox box = frame_.box(low, high);
    return visit_where([&](const Node& node) { return node.box.intersects(box); }, visit);
  }
  /// Calls visit(face) as for_each_near() does for the box of the triangle. Skips faces that meet
  /// the triangle at most in a common corner, because planes through a vertex of more than
  /// `most_uncrowded` faces separate them (star_planes.h).
  template <class Visit>
  bool for_each_in_contact(const Triangle& triangle, const Visit& visit) const;

  /// Returns the same face as ClosestPointQuery::closest_face_within() (closest_point.h), but does
  /// not visit all faces at a vertex near the point.
  Index closest_face_within(const Vec3& point, double distance, Index hint) const;

 private:
  struct Node {
    FloatBox box{};
    /// Vertex of many faces that all faces below the node share, with a box around their arcs;
    /// no_index if there is no such vertex.
    LinkBox hub{};
  };

  FloatBox box_of(const Triangle& triangle) const;
  Node leaf_node(Index face) const;
  static Node merged(const Node& first, const Node& second);
  bool is_beyond(const Vec3& point, double squared_distance, const Node& node) const;
  template <class Accept, class Visit>
  bool visit_where(const Accept& accept, const Visit& visit) const;

  const EditableMesh& mesh_;
  BoxFrame frame_;
  /// Number of faces at each vertex when the tree was built.
  std::vector<Index> valences_;
  /// Leaf of each face, as a node; no_index for faces removed before the tree was built.
  std::vector<Index> leaf_of_;
  std::vector<Index> face_of_;  ///< face of each leaf, beginning with the first leaf
  std::vector<Node> nodes_;     ///< children of node i: 2 i + 1 and 2 i + 2
};

template <class Accept, class Visit>
bool FaceTree::visit_where(const Accept& accept, const Visit& visit) const {
  const std::size_t first_leaf = nodes_.size() - face_of_.size();
  std::vector<std::size_t> waiting;
  if (!nodes_.empty()) waiting.push_back(0);
  while (!waiting.empty()) {
    const std::size_t node = waiting.back();
    waiting.pop_back();
    if (!accept(nodes_[node])) continue;
    if (node >= first_leaf) {
      if (!visit(face_of_[node - first_leaf])) return false;
    } else {
      waiting.push_back(2 * node + 2);
      waiting.push_back(2 * node + 1);
    }
  }
  return true;
}

template <class Visit>
bool FaceTree::for_each_in_contact(const Triangle& triangle, const Visit& visit) const {
  const FloatBox box = box_of(triangle);
  Index hub = no_index;
  std::optional<StarPlanes> planes;  // for `hub`
  const auto accept = [&](const Node& node) {
    if (!node.box.intersects(box)) return false;
    if (node.hub.link == no_index) return true;
    if (node.hub.link != hub) planes.emplace(mesh_.position(node.hub.link), triangle);
    hub = node.hub.link;
    return !planes->separate(node.hub.box);
  };
  return visit_where(accept, visit);
}

}  // namespace transformesh

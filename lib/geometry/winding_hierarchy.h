/// Generalized winding numbers of a mesh at many points. For a mesh with borders, the winding
/// number is any real number. Faces are in a tree of boxes. For a point outside a box, the faces in
/// it are replaced by a fan of triangles over their common boundary. The faces and the reversed fan
/// enclose a volume in the box, so faces and fan have the same solid angle at the point. This is no
/// approximation; results differ from those of SolidAngleWinding by rounding only.
///
/// Reference: Jacobson, Kavan & Sorkine-Hornung, "Robust inside-outside segmentation using
/// generalized winding numbers", ACM TOG 32(4), 2013, section 4.
///
/// Faces are connected by common vertex indices; unconnected faces are summed one by one. Floating
/// point; deterministic; thread-safe. Cost: O(n log n) to build, about O(sqrt(n)) per point for
/// surfaces that are connected and smooth.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "transformesh/measure.h"
#include "transformesh/mesh.h"

namespace transformesh {

class WindingHierarchy {
 public:
  /// Keeps a reference to the mesh.
  explicit WindingHierarchy(const Mesh& mesh);

  /// Returns the winding number of all faces except those in `left_out`. The point may be on a face
  /// in `left_out`. On any other face the winding number is undefined.
  double operator()(const Vec3& point, std::span<const Index> left_out = {}) const;

 private:
  /// Corners of a fan triangle, as indices relative to the first fan vertex of its node.
  using Corners = std::array<Index, 3>;
  /// A range of indices [first, last) of a list.
  struct Range {
    Index first = 0, last = 0;
  };
  struct Node {
    Box box{};
    Range faces;  ///< faces of the node, as a range of `order_`
    bool has_fan = false;
    Range vertices, triangles;  ///< fan of the node, as ranges of `vertices_` and `triangles_`
    Index left = no_index, right = no_index;
  };
  class Builder;
  struct Query;

  void add(const Node& node, Query& query) const;
  void add_fan(const Node& node, Query& query) const;
  void add_faces(const Node& node, Query& query) const;

  const Mesh* mesh_;
  double largest_coordinate_ = 0;
  std::vector<Index> order_;        ///< face indices in tree order: those of a node are consecutive
  std::vector<Vec3> vertices_;      ///< positions of the vertices of all fans
  std::vector<Corners> triangles_;  ///< triangles of all fans
  std::vector<Node> nodes_;         ///< nodes of the tree; the root is first
};

}  // namespace transformesh

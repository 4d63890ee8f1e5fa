/// The edges of one face, and which of them are near a point. Vertices are the same when their
/// indices are. Cost: O(n) to build, O(log n) a query on usual meshes. Deterministic.
#pragma once

#include <functional>
#include <vector>

#include "geometry/search/bvh.h"
#include "geometry/search/float_box.h"
#include "transformesh/mesh.h"

namespace transformesh {

class BorderEdges {
 public:
  /// Keeps a reference to the mesh.
  explicit BorderEdges(const Mesh& mesh);

  const std::vector<Index>& halfedges() const { return halfedges_; }
  /// The vertices of these edges, ascending.
  const std::vector<Index>& vertices() const { return vertices_; }

  /// A border halfedge that a vertex is near to, and the vertex's place along it, in [0, 1].
  struct Near {
    Index halfedge = 0;
    double distance = 0;
    double along = 0;
  };
  /// Calls visit(near) for each border edge within the distance of the vertex but those that end in
  /// it, in no particular order.
  void visit_near(Index vertex, double distance,
                  const std::function<void(const Near&)>& visit) const;

 private:
  const Mesh& mesh_;
  std::vector<Index> halfedges_, vertices_;
  BoxFrame frame_;
  Bvh bvh_;
};

}  // namespace transformesh

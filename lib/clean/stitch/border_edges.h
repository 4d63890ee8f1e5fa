/// Border edges (edges of one face), with a search for border edges near a vertex. Vertices are
/// equal if their indices are. Cost: O(n) to build, O(log n) per query on usual meshes.
/// Deterministic.
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
  /// Returns the vertices of the border edges, ascending.
  const std::vector<Index>& vertices() const { return vertices_; }

  /// A border halfedge near a vertex. `along` is the position of the halfedge's point nearest to
  /// the vertex, as a fraction of the halfedge's length, in [0, 1].
  struct Near {
    Index halfedge = 0;
    double distance = 0;
    double along = 0;
  };
  /// Calls visit(near) for each border edge within `distance` of the vertex, in no particular
  /// order. Skips the edges of which the vertex is an end.
  void visit_near(Index vertex, double distance,
                  const std::function<void(const Near&)>& visit) const;

 private:
  const Mesh& mesh_;
  std::vector<Index> halfedges_, vertices_;
  BoxFrame frame_;
  Bvh bvh_;
};

}  // namespace transformesh

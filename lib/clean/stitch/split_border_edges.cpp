#include "clean/stitch/split_border_edges.h"

#include <algorithm>
#include <tuple>

#include "clean/stitch/border_edges.h"

namespace transformesh {
namespace {

/// A vertex that splits a halfedge. `along` is the position of the split, as a fraction of the
/// length of the halfedge.
struct Split {
  Index halfedge;
  double along;
  Index vertex;

  auto key() const { return std::tie(halfedge, along, vertex); }
};

std::vector<Split> find_splits(const Mesh& mesh, double tolerance) {
  const BorderEdges borders(mesh);
  std::vector<Split> splits;
  for (const Index vertex : borders.vertices())
    borders.visit_near(vertex, tolerance, [&](const BorderEdges::Near& near) {
      const Index apex = halfedge_source(mesh, previous_halfedge(near.halfedge));
      if (apex != vertex && near.along > 0 && near.along < 1)
        splits.push_back({near.halfedge, near.along, vertex});
    });
  std::ranges::sort(splits, {}, &Split::key);
  return splits;
}

/// Cuts faces at the vertices that split their edges, one edge after the other.
class FaceCutter {
 public:
  explicit FaceCutter(Mesh& mesh) : mesh_(mesh) {}

  /// Splits an edge of the face at the given vertices, which are in order along the edge. The edge
  /// starts at corner `corner` (0 to 2).
  void cut(Index face, Index corner, const std::vector<Index>& vertices);
  BorderSplits take() { return std::move(result_); }

 private:
  Mesh& mesh_;
  BorderSplits result_;
  Index face_ = no_index;  ///< face whose edges are being cut
  /// For each edge of the original face `face_`, the triangle that contains this edge after the
  /// cuts made so far.
  std::array<Index, 3> holder_{};
};

void FaceCutter::cut(Index face, Index corner, const std::vector<Index>& vertices) {
  if (face != face_) holder_ = {face, face, face};
  face_ = face;
  const Index piece = holder_[corner];
  // Create a fan of triangles. Each triangle has two consecutive vertices on the split edge, and
  // the corner opposite to this edge.
  const Face whole = mesh_.faces[piece];
  Index from = whole[corner];
  for (const Index v : vertices) {
    Face part = whole;
    part[corner] = from;
    part[(corner + 1) % 3] = v;
    if (from == whole[corner]) {
      mesh_.faces[piece] = part;
    } else {
      mesh_.faces.push_back(part);
      result_.face_source.push_back(face);
    }
    from = v;
  }
  Face last = whole;
  last[corner] = from;
  mesh_.faces.push_back(last);
  result_.face_source.push_back(face);
  // The last triangle of the fan contains the next edge of the face, unless an earlier cut moved
  // this edge to another triangle.
  const Index next = (corner + 1) % 3;
  if (holder_[next] == piece) holder_[next] = static_cast<Index>(mesh_.faces.size() - 1);
  ++result_.edges;
}

}  // namespace

BorderSplits split_border_edges(Mesh& mesh, double tolerance) {
  const std::vector<Split> splits = find_splits(mesh, tolerance);
  FaceCutter cutter(mesh);
  for (auto first = splits.begin(); first != splits.end();) {
    std::vector<Index> vertices;
    auto last = first;
    for (; last != splits.end() && last->halfedge == first->halfedge; ++last)
      if (vertices.empty() || vertices.back() != last->vertex) vertices.push_back(last->vertex);
    cutter.cut(first->halfedge / 3, first->halfedge % 3, vertices);
    first = last;
  }
  return cutter.take();
}

}  // namespace transformesh

#include "clean/stitch/split_singular_edges.h"

#include <map>

#include "mesh/edges.h"

namespace transformesh {
namespace {

class Splitter {
 public:
  Splitter(Mesh& mesh, std::vector<Index>& opposite)
      : mesh_(mesh), opposite_(opposite), old_faces_(mesh.faces.size()) {}
  EdgeSplits split();

 private:
  std::vector<Index> find_singular();
  void split_sheet(Index halfedge);
  Index split_face(Index halfedge, Index vertex);
  void pair(Index first, Index second);
  Index source(Index face) const;

  Mesh& mesh_;
  std::vector<Index>& opposite_;
  const std::size_t old_faces_;
  std::map<Index, Index> moved_;  ///< maps halfedges that moved to a new face to their new indices
  EdgeSplits result_;
};

Index Splitter::source(Index face) const {
  return face < old_faces_ ? face : result_.face_source[face - old_faces_];
}

void Splitter::pair(Index first, Index second) {
  opposite_[first] = second;
  if (second != no_index) opposite_[second] = first;
}

// Cuts a face in two, from `vertex` on halfedge `h` to the opposite corner. The face keeps the
// first half of the halfedge. Returns the halfedge of the second half, which belongs to a new face.
Index Splitter::split_face(Index h, Index vertex) {
  const Index face = h / 3, next = next_halfedge(h), before = previous_halfedge(h);
  const auto added = static_cast<Index>(mesh_.faces.size());
  Face second = mesh_.faces[face];
  second[h % 3] = vertex;
  mesh_.faces[face][next % 3] = vertex;
  mesh_.faces.push_back(second);
  opposite_.resize(3 * mesh_.faces.size(), no_index);
  result_.face_source.push_back(source(face));
  result_.cut_faces.push_back(source(face));

  // The edge that follows the split edge now belongs to the new face. In the old face, the new edge
  // from `vertex` to the opposite corner replaces it.
  pair(3 * added + next % 3, opposite_[next]);
  moved_[next] = 3 * added + next % 3;
  pair(next, 3 * added + before % 3);
  return 3 * added + h % 3;
}

void Splitter::split_sheet(Index h) {
  const auto midpoint = static_cast<Index>(mesh_.positions.size());
  const Index from = halfedge_source(mesh_, h), to = halfedge_target(mesh_, h);
  mesh_.positions.emplace_back(0.5 * (mesh_.positions[from] + mesh_.positions[to]));
  result_.vertices.push_back({source(h / 3), {from, to}});
  const Index across = opposite_[h];
  const Index second = split_face(h, midpoint);
  if (across == no_index) return;
  const Index second_across = split_face(across, midpoint);
  pair(h, second_across);
  pair(across, second);
}

// Returns one halfedge for each cut at an edge of more than two faces. These are one of each pair
// of opposite halfedges, and each halfedge without opposite.
std::vector<Index> Splitter::find_singular() {
  const Edges edges(mesh_);
  std::vector<Index> singular;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges.halfedges(e).size() <= 2) continue;
    ++result_.edges;
    for (const Index h : edges.halfedges(e)) {
      if (opposite_[h] == no_index || h < opposite_[h]) singular.push_back(h);
    }
  }
  return singular;
}

// Splits edges until no edge has more than two faces. More than one round may be needed. If a sheet
// has two faces with the same corners, both are cut at the same edge. Then both cuts end at the
// same corner, and together they may form a new edge of more than two faces.
EdgeSplits Splitter::split() {
  for (auto singular = find_singular(); !singular.empty(); singular = find_singular()) {
    for (Index h : singular) {
      for (auto it = moved_.find(h); it != moved_.end(); it = moved_.find(h)) h = it->second;
      split_sheet(h);
    }
    moved_.clear();
  }
  return std::move(result_);
}

}  // namespace

EdgeSplits split_singular_edges(Mesh& mesh, std::vector<Index>& opposite) {
  return Splitter(mesh, opposite).split();
}

}  // namespace transformesh

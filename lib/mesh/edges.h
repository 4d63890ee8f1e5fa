/// The undirected edges of a mesh, each with its halfedges. Vertices are identified by index, not
/// by position. A halfedge from a vertex to itself (in a face with a repeated vertex) is ignored.
/// Edges are sorted by their smaller vertex, then by their larger one; the halfedges of an edge are
/// in ascending order. Parallel. Cost: O(n) for vertices of bounded valence, O(n log n) at worst;
/// deterministic.
#pragma once

#include <span>
#include <vector>

#include "support/raw_vector.h"
#include "transformesh/mesh.h"

namespace transformesh {

class Edges {
 public:
  Edges() = default;
  explicit Edges(const Mesh& mesh) : Edges(mesh.faces, mesh.positions.size()) {}
  Edges(std::span<const Face> faces, std::size_t vertices);

  std::size_t size() const { return offsets_.size() - 1; }
  std::span<const Index> halfedges(std::size_t edge) const {
    return {halfedges_.data() + offsets_[edge], halfedges_.data() + offsets_[edge + 1]};
  }

 private:
  RawVector<Index> halfedges_;
  RawVector<Index> offsets_ = RawVector<Index>(1, 0);
};

/// Returns, for every halfedge, the other halfedge of its edge if the edge has exactly two
/// halfedges, in any direction; otherwise no_index.
std::vector<Index> neighbors_across(const Edges& edges, std::size_t faces);

/// Returns the same faces, but replaces all corners of a face with a repeated vertex by one vertex,
/// so that the face has no edges.
std::vector<Face> without_collapsed(std::span<const Face> faces);

}  // namespace transformesh

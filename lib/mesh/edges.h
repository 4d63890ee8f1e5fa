/// The undirected edges of a mesh, each with the halfedges along it. Vertices are the same
/// when their indices are. A halfedge from a vertex to itself (a face that names a vertex twice) is
/// no edge and appears nowhere.
/// Edges are sorted by their smaller vertex, then by their larger one; the halfedges of an edge
/// ascend. Cost: O(n) for vertices of bounded valence, O(n log n) at worst; deterministic.
#pragma once

#include <span>
#include <vector>

#include "mesh/mesh.h"

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
  std::vector<Index> halfedges_;
  std::vector<Index> offsets_{0};
};

/// For every halfedge the other one of its edge if that has exactly two, in any directions;
/// else no_index.
std::vector<Index> neighbors_across(const Edges& edges, std::size_t faces);

/// The same faces, but those that name a vertex twice name one vertex only, and so have no edges.
std::vector<Face> without_collapsed(std::span<const Face> faces);

}  // namespace transformesh

/// The triangles at a vertex, measured two at a time.
#pragma once

#include <span>
#include <vector>

#include "remesh/halfedges/editable_mesh.h"
#include "remesh/halfedges/number_pair.h"

namespace transformesh {

/// Triangle i lies between neighbors i and i + 1 of the vertex, counter-clockwise.
class VertexStar {
 public:
  /// Of neighbors and triangles 2 k and 2 k + 1; beyond the last, numbers mean nothing.
  struct Pair {
    VectorPair rim;             ///< positions of the neighbors
    VectorPair way;             ///< to them from the vertex
    NumberPair way_squared;     ///< its length
    VectorPair normal;          ///< of the triangles, twice the area long
    NumberPair squared;         ///< its length
    NumberPair across_squared;  ///< of the side across from the vertex
    NumberPair squares;         ///< of the three sides, summed
  };

  void gather(const EditableMesh& mesh, Index vertex);
  /// The same, given the ring (vertex_rings.h), which has to stay.
  void gather(const EditableMesh& mesh, Index vertex, std::span<const Index> neighbors);

  std::size_t size() const { return ring_.size() - 1; }  ///< number of triangles
  std::span<const Index> ring() const { return ring_; }
  const Vec3& center() const { return center_; }
  const Vec3& normal() const { return normal_; }  ///< sum of the area normals, doubled
  /// From the center to the farthest neighbor.
  double reach_squared() const { return reach_squared_; }
  Vec3 rim(std::size_t i) const {
    const VectorPair& two = pairs_[i / 2].rim;
    return {two.x[i % 2], two.y[i % 2], two.z[i % 2]};
  }
  /// Those of the triangles, and one more.
  const Pair* pairs() const { return pairs_.data(); }
  std::size_t pair_count() const { return (size() + 1) / 2; }
  /// Of a pair of triangles, which of them are there.
  MaskPair is_there(std::size_t pair) const { return MaskPair{-1, 2 * pair + 1 < size() ? -1 : 0}; }

 private:
  void measure_neighbors(const EditableMesh& mesh);
  void measure_triangles();

  std::vector<Pair> pairs_;
  std::span<const Index> ring_;
  Vec3 center_ = Vec3::Zero();
  Vec3 normal_ = Vec3::Zero();
  double reach_squared_ = 0;
  std::vector<Index> own_ring_;
};

}  // namespace transformesh

/// Measures the triangles at a vertex, two at a time.
#pragma once

#include <span>
#include <vector>

#include "remesh/halfedges/editable_mesh.h"
#include "remesh/halfedges/number_pair.h"

namespace transformesh {

/// Triangle i lies between neighbors i and i + 1 of the vertex, counter-clockwise.
class VertexStar {
 public:
  /// Data of the neighbors 2 k and 2 k + 1 and of the triangles with these numbers. Entries after
  /// the last triangle are undefined.
  struct Pair {
    VectorPair rim;             ///< positions of the neighbors
    VectorPair way;             ///< vectors from the vertex to the neighbors
    NumberPair way_squared;     ///< squared lengths of the vectors in `way`
    VectorPair normal;          ///< normals of the triangles; the length is twice the area
    NumberPair squared;         ///< squared lengths of the normals
    NumberPair across_squared;  ///< squared lengths of the sides opposite the vertex
    NumberPair squares;         ///< sums of the squared lengths of the three sides
  };

  void gather(const EditableMesh& mesh, Index vertex);
  /// Gathers the star from a known ring (vertex_rings.h), which must outlive the use of this
  /// object.
  void gather(const EditableMesh& mesh, Index vertex, std::span<const Index> neighbors);

  std::size_t size() const { return ring_.size() - 1; }  ///< number of triangles
  std::span<const Index> ring() const { return ring_; }
  const Vec3& center() const { return center_; }
  const Vec3& normal() const { return normal_; }  ///< twice the sum of the area normals
  /// Returns the squared distance of the farthest neighbor.
  double reach_squared() const { return reach_squared_; }
  Vec3 rim(std::size_t i) const {
    const VectorPair& two = pairs_[i / 2].rim;
    return {two.x[i % 2], two.y[i % 2], two.z[i % 2]};
  }
  /// Returns the pairs of all triangles, followed by one more pair.
  const Pair* pairs() const { return pairs_.data(); }
  std::size_t pair_count() const { return (size() + 1) / 2; }
  /// Returns for both triangles of a pair whether they exist: the last pair may have only one
  /// triangle.
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

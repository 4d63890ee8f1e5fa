/// Moves a single vertex if the conditions of smooth.h hold.
#pragma once

#include "remesh/guards/embedding_guard.h"
#include "remesh/halfedges/triangle_quality.h"
#include "remesh/halfedges/vertex_rings.h"
#include "remesh/halfedges/vertex_star.h"

namespace transformesh {

class VertexMover {
 public:
  /// Triangles with at least this roundness() (triangle_quality.h) may become less round, down to
  /// this value; other triangles must not become less round. With a larger value, more movements
  /// are refused.
  static constexpr double round_enough = 0.6;
  VertexMover(EditableMesh& mesh, EmbeddingGuard& guard, double enough = round_enough)
      : mesh_(mesh), guard_(guard), enough_(enough) {}

  /// Moves the vertex to `target`, or half of the way. Returns false if both movements are refused.
  bool move(Index vertex, const VertexStar& star, const Vec3& target);

 private:
  bool attempt(Index vertex, const VertexStar& star, const Vec3& wanted);
  void place_ways(const VertexStar& star, const Vec3& target);
  bool place_triangles(const VertexStar& star, const Vec3& target);
  bool is_allowed(Index vertex, const VertexStar& star, const Vec3& target);
  void name_vertices(Index vertex, const VertexStar& star);
  void name_faces(Index vertex, const VertexStar& star, const Vec3& target);

  struct WayPair {
    VectorPair way;  ///< vectors from the target to the neighbors
    NumberPair squared;
  };

  EditableMesh& mesh_;
  EmbeddingGuard& guard_;
  bool has_thin_ = false;  ///< true if a triangle of the star would have no reliable normal
  double enough_;
  std::vector<WayPair> ways_;
  std::vector<NormalPair> normals_;  ///< normals of the moved triangles
  Patch patch_;
};

}  // namespace transformesh

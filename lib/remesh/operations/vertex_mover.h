/// Moves one vertex where all that the operations promise stays true.
#pragma once

#include "remesh/guards/embedding_guard.h"
#include "remesh/halfedges/triangle_quality.h"
#include "remesh/halfedges/vertex_rings.h"
#include "remesh/halfedges/vertex_star.h"

namespace transformesh {

class VertexMover {
 public:
  /// Triangles at least so round (roundness() in star.h) are good enough; others must not get
  /// worse.
  static constexpr double round_enough = 0.6;
  VertexMover(EditableMesh& mesh, EmbeddingGuard& guard, double enough = round_enough)
      : mesh_(mesh), guard_(guard), enough_(enough) {}

  /// Moves the vertex to `target`, or half the way; false where neither is sound.
  bool move(Index vertex, const VertexStar& star, const Vec3& target);

 private:
  bool attempt(Index vertex, const VertexStar& star, const Vec3& wanted);
  void place_ways(const VertexStar& star, const Vec3& target);
  bool place_triangles(const VertexStar& star, const Vec3& target);
  bool is_allowed(Index vertex, const VertexStar& star, const Vec3& target);
  void name_vertices(Index vertex, const VertexStar& star);
  void name_faces(Index vertex, const VertexStar& star, const Vec3& target);

  struct WayPair {
    VectorPair way;  ///< from the target to the rim
    NumberPair squared;
  };

  EditableMesh& mesh_;
  EmbeddingGuard& guard_;
  bool has_thin_ = false;  ///< whether a triangle of the star would have no reliable normal
  double enough_;
  std::vector<WayPair> ways_;
  std::vector<NormalPair> normals_;  ///< of the triangles where they would be
  Patch patch_;
};

}  // namespace transformesh

/// Moves one vertex where all that the operations promise stays true.
#pragma once

#include "tm/remesh/embedding_guard.h"
#include "tm/remesh/star.h"
#include "tm/remesh/vertex_rings.h"

namespace transformesh {

/// The triangles at a vertex, without that corner, counter-clockwise.
struct Star {
  struct Triangle {
    Vec3 normal;            ///< twice the area long
    double normal_squared;  ///< its length
    double across_squared;  ///< of the side across from the vertex
    double squares;         ///< of the three sides, summed
  };
  std::vector<Triangle> triangles;
  std::span<const Index> ring;  ///< triangle i lies between neighbors i and i + 1
  std::vector<Vec3> rim;        ///< their positions
  Vec3 center;
  Vec3 normal;           ///< sum of the area normals, doubled
  double reach_squared;  ///< from the center to the farthest neighbor

  void gather(const EditableMesh& mesh, Index vertex);
  /// The same, given the ring (vertex_rings.h), which has to stay.
  void gather(const EditableMesh& mesh, Index vertex, std::span<const Index> neighbors);

 private:
  std::vector<Index> own_ring_;
};

class VertexMover {
 public:
  /// Triangles at least so round (roundness() in star.h) are good enough; others must not get
  /// worse.
  static constexpr double round_enough = 0.6;
  VertexMover(EditableMesh& mesh, EmbeddingGuard& guard, double enough = round_enough)
      : mesh_(mesh), guard_(guard), enough_(enough) {}

  /// Moves the vertex to `target`, or half the way; false where neither is sound.
  bool move(Index vertex, const Star& star, const Vec3& target);

 private:
  bool attempt(Index vertex, const Star& star, const Vec3& wanted);
  bool place_triangles(const Star& star, const Vec3& target);
  bool is_allowed(Index vertex, const Star& star, const Vec3& target);
  void name_vertices(Index vertex, const Star& star);
  void name_faces(Index vertex, const Star& star, const Vec3& target);

  EditableMesh& mesh_;
  EmbeddingGuard& guard_;
  double enough_;
  Patch patch_;
};

}  // namespace transformesh

/// Moves one vertex where all that the operations promise stays true.
#pragma once

#include "tm/remesh/embedding_guard.h"
#include "tm/remesh/star.h"

namespace transformesh {

/// The triangles at a vertex, without that corner, counter-clockwise: the second corner of one is
/// the first of the next.
struct Star {
  struct Spoke {
    Index first;
    Index face;
    Vec3 first_position;
    Vec3 second_position;
    Vec3 normal;     ///< twice the area long
    double rim;      ///< squared length of the side across
    double squares;  ///< of the three sides, summed
  };
  std::vector<Spoke> spokes;
  Vec3 center;
  Vec3 normal;  ///< sum of the area normals, doubled

  void gather(const EditableMesh& mesh, Index vertex);
};

class VertexMover {
 public:
  VertexMover(EditableMesh& mesh, EmbeddingGuard& guard) : mesh_(mesh), guard_(guard) {}

  /// Moves the vertex to `target`, or half the way; false where neither is sound.
  bool move(Index vertex, const Star& star, const Vec3& target);

 private:
  bool attempt(Index vertex, const Star& star, const Vec3& wanted);
  bool place_triangles(const Star& star, const Vec3& target);
  void name_parts(Index vertex, const Star& star);

  EditableMesh& mesh_;
  EmbeddingGuard& guard_;
  Patch patch_;
};

}  // namespace transformesh

/// Replaces some faces of a mesh by their pieces. Deterministic. Cost: O(n).
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Result of cleaning a mesh or a part of it.
struct CleanedFaces {
  Mesh mesh;
  /// For each face the face of the whole mesh of which it is a piece.
  std::vector<Index> source_face;
};

/// Returns 1 for each face that equals its source.
std::vector<bool> find_uncut(const Mesh& mesh, const CleanedFaces& cleaned);

/// Replaces the faces with a set `is_replaced` entry by their pieces. Uncut faces keep their place;
/// other pieces follow all faces. The remaining faces keep their vertices, order and columns.
/// Pieces share vertices with the remaining faces if cleaning joined them. Vertices that lose all
/// their faces are removed; new vertices follow.
Mesh replace_faces(const Mesh& mesh, const std::vector<bool>& is_replaced,
                   const CleanedFaces& cleaned);

}  // namespace transformesh

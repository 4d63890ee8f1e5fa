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

/// Returns true for each cleaned face that equals the face from which it is cut, corner by corner.
std::vector<bool> find_uncut(const Mesh& mesh, const CleanedFaces& cleaned);

/// Replaces the faces whose `is_replaced` entry is true by their pieces. If a face was not cut, its
/// piece takes its place; pieces of cut faces follow all other faces. The remaining faces keep
/// their vertices, order and columns. Pieces share vertices with the remaining faces if they also
/// do in `cleaned`. Vertices that lose all their faces are removed; new vertices follow.
Mesh replace_faces(const Mesh& mesh, const std::vector<bool>& is_replaced,
                   const CleanedFaces& cleaned);

}  // namespace transformesh

/// The pieces of some faces of a mesh in the place of these faces. Deterministic. Cost: O(n).
#pragma once

#include <vector>

#include "mesh/mesh.h"

namespace transformesh {

/// What cleaning made of a mesh or of a part of it.
struct CleanedFaces {
  Mesh mesh;
  std::vector<Index> source_face;  ///< per face: the face of the whole mesh that it is a piece of
};

/// Whether each face is its source, uncut.
std::vector<bool> find_uncut(const Mesh& mesh, const CleanedFaces& cleaned);

/// Faces for which is_replaced[face] holds become their pieces: uncut ones in their place, others
/// behind all. Other faces keep their vertices, order and columns, and pieces share these vertices
/// where they have been joined with them. Vertices go that lose all their faces; new ones follow.
Mesh replace_faces(const Mesh& mesh, const std::vector<bool>& is_replaced,
                   const CleanedFaces& cleaned);

}  // namespace transformesh

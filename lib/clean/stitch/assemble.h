/// The kept pieces of an arrangement as a mesh (paper 3.3). What no intersection touched keeps its
/// vertices, its faces and their order; new vertices and faces follow. Singular vertices and edges
/// (paper 3.3.1 and 3.3.2) are duplicated. Where copies of its ends would leave four faces on one
/// edge, each sheet gets a midpoint of its own. New vertices interpolate their columns in the face
/// on which they lie, and pieces inherit those of the face that they are cut from.
/// Cost: O(n log n). Deterministic.
#pragma once

#include <vector>

#include "clean/arrange/arrange.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct Assembly {
  Mesh mesh;
  std::vector<Index> input_vertex;  ///< per vertex: the input vertex at its position, or no_index
  std::vector<char> vertex_is_new;  ///< per vertex: neither one of the input nor a copy of one
  std::vector<char> face_is_new;    ///< per face: not a whole face of the input
  std::vector<Index> source_face;   ///< per face: the input face that it is, or is cut from
  std::size_t copies = 0;           ///< vertices duplicated at singular vertices and edges
  std::size_t split_edges = 0;      ///< singular edges split in the middle
};

/// Kept are the pieces for which kept[piece] holds.
Assembly assemble(const Mesh& input, const Arrangement& arrangement, const std::vector<char>& kept);

}  // namespace transformesh

/// Makes a mesh of the kept pieces (triangles) of an arrangement (paper 3.3). Vertices and faces
/// that take part in no intersection come first, in their order; new vertices and faces follow.
/// Singular vertices and edges, at which several sheets meet (paper 3.3.1 and 3.3.2), are
/// duplicated. If an edge still has four or more faces after its ends are duplicated, each sheet
/// gets its own midpoint of this edge. New vertices interpolate their columns in a face that
/// contains them; pieces inherit the columns of the face from which they are cut. Cost: O(n log n).
/// Deterministic.
#pragma once

#include <vector>

#include "clean/arrange/arrange.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct Assembly {
  Mesh mesh;
  /// For each vertex, the input vertex at the same position, or no_index.
  std::vector<Index> input_vertex;
  /// 1 for each vertex that is neither an input vertex nor a duplicate of one.
  std::vector<char> vertex_is_new;
  /// 1 for each face that is new or was cut; 0 for each face that equals an input face.
  std::vector<char> face_is_new;
  /// For each face: the input face that is equal to it, or from which it is cut.
  std::vector<Index> source_face;
  /// Number of vertices added as duplicates at singular vertices and edges.
  std::size_t copies = 0;
  std::size_t split_edges = 0;  ///< number of singular edges split at their midpoints
};

/// Makes a mesh of the pieces (triangles of the arrangement) with a nonzero entry in `kept`.
/// `input` is the mesh that was arranged.
Assembly assemble(const Mesh& input, const Arrangement& arrangement, const std::vector<char>& kept);

}  // namespace transformesh

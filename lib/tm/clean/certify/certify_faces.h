/// What the faces of a result have to do with those of the mesh that it came from, and which of
/// them to sample. Vertices are the same when their positions are.
#pragma once

#include <vector>

#include "tm/mesh/mesh.h"
#include "tm/support/progress.h"

namespace transformesh {

struct FaceMatch {
  bool input_is_closed = false;      ///< every edge is run along as often both ways
  std::vector<char> input_vanished;  ///< per input face: no face of the output
  std::vector<char> output_is_new;   ///< per output face: no face of the input
};

FaceMatch match_faces(const Mesh& input, const Mesh& output);

/// Regions of input faces that intersect no other, connected across edges of two such faces; each
/// in ascending order.
struct Patches {
  std::vector<std::vector<Index>> faces;
  std::vector<char> is_cut;  ///< per input face: it intersects another
};

Patches find_patches(const Mesh& input, const Progress& progress);

/// At most `count` of them, evenly spread, the first included.
std::vector<Index> spread(const std::vector<Index>& faces, std::size_t count);

/// The faces for which mark[face] == value.
std::vector<Index> marked_faces(const std::vector<char>& marks, char value);

}  // namespace transformesh

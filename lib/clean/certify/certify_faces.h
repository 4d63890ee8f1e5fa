/// Which faces of a result are those of the mesh that it came from, and which of them to sample.
/// Vertices are the same when their positions are.
#pragma once

#include <vector>

#include "mesh/mesh.h"
#include "support/progress.h"

namespace transformesh {

struct FaceMatch {
  bool input_is_closed = false;      ///< every edge is traversed equally often in both directions
  std::vector<char> input_vanished;  ///< per input face: it is no face of the output
  std::vector<char> output_is_new;   ///< per output face: it is no face of the input
};

FaceMatch match_faces(const Mesh& input, const Mesh& output);

/// Regions of input faces that intersect no other, connected across edges of two such faces. They
/// lie within the patches of the arrangement (exterior/patches.h).
struct UncutPatches {
  std::vector<std::vector<Index>> faces;  ///< of each patch, ascending
  std::vector<char> is_cut;               ///< per input face: it intersects another
};

UncutPatches find_uncut_patches(const Mesh& input, const Progress& progress);

/// At most `count` of the faces, evenly spread, with the first among them.
std::vector<Index> spread(const std::vector<Index>& faces, std::size_t count);

/// The faces for which mark[face] == value.
std::vector<Index> marked_faces(const std::vector<char>& marks, char value);

}  // namespace transformesh

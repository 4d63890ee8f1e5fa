/// Matches the faces of a result with those of its input, and selects faces to sample. Vertices
/// count as equal if their positions are equal. Cost: O(n log n).
#pragma once

#include <vector>

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct FaceMatch {
  /// True if each edge of the input is traversed equally often in both directions.
  bool input_is_closed = false;
  std::vector<char> input_vanished;  ///< 1 for each input face that is not a face of the output
  std::vector<char> output_is_new;   ///< 1 for each output face that is not a face of the input
};

FaceMatch match_faces(const Mesh& input, const Mesh& output);

/// Regions of connected input faces that intersect no other face. Faces are connected across edges
/// of two faces. Each region is inside one patch of the arrangement (exterior/patches.h).
struct UncutPatches {
  std::vector<std::vector<Index>> faces;  ///< faces of each region, ascending
  std::vector<char> is_cut;               ///< 1 for each input face that intersects another face
};

UncutPatches find_uncut_patches(const Mesh& input, const Progress& progress);

/// Returns at most `count` of the faces, evenly spread; the first face is included.
std::vector<Index> spread(const std::vector<Index>& faces, std::size_t count);

/// Returns the faces with marks[face] == value.
std::vector<Index> marked_faces(const std::vector<char>& marks, char value);

}  // namespace transformesh

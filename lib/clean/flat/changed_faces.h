/// Finds the changed faces of a cleaned mesh. These are the pieces of cut faces, and all faces at
/// positions of corners of input faces that were cut or removed. Cost: O(n log n). Deterministic.
#pragma once

#include <span>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns 1 for each changed face of `result`. Faces with a zero `face_is_new` entry must be faces
/// of the input.
std::vector<char> find_changed_faces(const Mesh& input, const Mesh& result,
                                     std::span<const Index> source_face,
                                     std::span<const char> face_is_new);

}  // namespace transformesh

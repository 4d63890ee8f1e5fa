/// Finds the changed faces of a cleaned mesh: pieces of cut faces, and faces at the corners of
/// input faces that were cut or removed. Cost: O(n log n). Deterministic.
#pragma once

#include <span>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns 1 for each changed face of `result`. Faces of the result that are not new must be whole
/// faces of the input.
std::vector<char> find_changed_faces(const Mesh& input, const Mesh& result,
                                     std::span<const Index> source_face,
                                     std::span<const char> face_is_new);

}  // namespace transformesh

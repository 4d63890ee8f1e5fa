/// The sign of a volume, which decides whether a body is inside out. Uses doubles with an error
/// bound, and exact numbers if these do not decide.
#pragma once

#include <span>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns the exact sign of the volume inside the closed surface that these faces form: negative
/// if it is inside out. There must be a face, and coordinates must be finite.
int volume_sign(const Mesh& mesh, std::span<const Index> faces);

}  // namespace transformesh

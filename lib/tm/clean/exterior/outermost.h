/// Keeps the outermost skin of a clean mesh: drops the components that bound cavities, and the
/// components that float in them. Returns how many were dropped.
#pragma once

#include "tm/mesh/mesh.h"

namespace transformesh {

std::size_t drop_enclosed_components(Mesh& mesh);

}  // namespace transformesh

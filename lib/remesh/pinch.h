/// Lets thin necks and handles of a surface part, as those of fluids do.
#pragma once

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct PinchResult {
  std::size_t cut = 0;      ///< loops along which the surface was cut and capped
  std::size_t refused = 0;  ///< loops around which no caps fit
};

/// Cuts handles (handles.h) and necks (fill/necks.h) around which a loop of edges of at most
/// `length` goes, and caps both sides. If caps intersect the surface, clean() resolves that. A mesh
/// without such loops stays as it is. Throws InputError for a mesh that is no closed oriented
/// manifold. Pre: `length` > 0.
PinchResult pinch(Mesh& mesh, double length, Scalar coordinate, const Progress& progress);

}  // namespace transformesh

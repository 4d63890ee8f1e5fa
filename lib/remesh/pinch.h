/// Cuts thin necks and handles of a surface, as surface tension does in liquids.
#pragma once

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct PinchResult {
  std::size_t cut = 0;      ///< loops along which the surface was cut and capped
  std::size_t refused = 0;  ///< loops around which no caps fit
};

/// Cuts handles (handles.h) and necks (fill/necks.h) along loops of edges of at most `length`, and
/// caps both sides. If caps intersect the surface, clean() resolves that. A mesh without such loops
/// stays unchanged. Throws InputError if the mesh is not a closed oriented manifold. Pre: `length`
/// > 0.
PinchResult pinch(Mesh& mesh, double length, Scalar coordinate, const Progress& progress);

}  // namespace transformesh

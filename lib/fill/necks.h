/// Cuts a closed surface through at its necks (neck_loops.h) and caps both sides (loop_cutter.h).
///
/// Guarantees: the result is a closed oriented manifold. Vertices and faces that were there stay,
/// with order and columns, but for the vertices of the loops, which move; new ones follow, with
/// columns as in fill.h. The surface may intersect itself at caps: clean() resolves that.
/// Deterministic for any number of threads. Cost: that of narrow_loops() for each round.
#pragma once

#include <cstddef>

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct NeckResult {
  std::size_t cut = 0;
  std::size_t refused = 0;  ///< loops along which no caps fit, or whose caps meet other parts
};

/// Cuts at loops of at most `max_length`, which is above 0, the shortest first. Positions are
/// rounded to `coordinate`. Throws InputError for a mesh that is no closed oriented manifold.
NeckResult cut_necks(Mesh& mesh, double max_length, Scalar coordinate,
                     const Progress& progress = Progress());

}  // namespace transformesh

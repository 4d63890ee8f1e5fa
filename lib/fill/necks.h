/// Cuts a closed surface at its necks (neck_loops.h), and caps both sides of each cut
/// (loop_cutter.h).
///
/// Guarantees: the result is a closed oriented manifold. Input vertices and faces stay, with order
/// and columns; only the vertices of loops move. New vertices and faces follow, with columns as in
/// fill.h. The surface may intersect itself at caps; clean() resolves this. Deterministic for any
/// number of threads. Cost: that of narrow_loops() for each round.
#pragma once

#include <cstddef>

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct NeckResult {
  std::size_t cut = 0;
  /// Loops that were not cut: no caps fit, or caps would meet other parts.
  std::size_t refused = 0;
};

/// Cuts along loops of at most `max_length`, the shortest first. Pre: `max_length` > 0. Positions
/// are rounded to `coordinate`. Throws InputError if the mesh is not a closed oriented manifold.
NeckResult cut_necks(Mesh& mesh, double max_length, Scalar coordinate,
                     const Progress& progress = Progress());

}  // namespace transformesh

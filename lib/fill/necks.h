/// Cuts a closed surface at its necks (neck_loops.h), and caps both sides of each cut
/// (loop_cutter.h).
///
/// Guarantees: the result is a closed oriented manifold. Input vertices and faces stay, and keep
/// their order and columns. Only the vertices of loops along which the surface is cut move. New
/// vertices and faces follow, with columns as in fill.h. The surface may intersect itself at caps;
/// clean() removes these intersections. Deterministic for any number of threads. Cost: that of
/// narrow_loops() for each round.
#pragma once

#include <cstddef>

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct NeckResult {
  std::size_t cut = 0;
  /// Number of loops in the last round that were not cut, because no caps fit, or because caps
  /// would meet other parts of the surface.
  std::size_t refused = 0;
};

/// Cuts along loops of at most `max_length`, the shortest first. Precondition: `max_length` > 0.
/// Positions of moved and new vertices are rounded to type `coordinate`. Throws InputError if the
/// mesh is not a closed oriented manifold.
NeckResult cut_necks(Mesh& mesh, double max_length, Scalar coordinate,
                     const Progress& progress = Progress());

}  // namespace transformesh

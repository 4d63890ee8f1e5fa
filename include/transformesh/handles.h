/// Removes thin handles: bridges that a short loop goes around are cut through, narrow tunnels are
/// closed, the shortest loop first; which of both one is, its shape alone says (Guskov and Wood,
/// Topological noise removal, Graphics Interface 2001). What noise or webs between near parts leave
/// goes; a wide tunnel stays, and so does every thin part that is no handle.
/// The surface is slit along the loop (short_loops.h), the two sides are drawn back by a third of
/// an edge, and each is closed by a patch (hole_patch.h).
///
/// Guarantees: the result is a closed oriented manifold with as many components; every handle
/// removed lowers the genus by one. Vertices and faces that were there stay, with order and
/// columns, but for the vertices of the loop, which move; new ones follow, with columns as in
/// fill.h. The surface may intersect itself where it was slit: clean() resolves that. No patch
/// meets another component, or the same one farther than two rings from the loop, and none of them
/// lies between the patches: cavities stay sealed, and clean() keeps the components. Deterministic
/// for any number of threads.
///
/// Throws InputError for a mesh that is no closed oriented manifold, UsageError for a length that
/// is not greater than 0. Cost: that of short_loops() for each round, and O(n) for each handle.
#pragma once

#include <cstddef>

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct HandleOptions {
  double max_length = 0;                ///< of the loop around a handle; input units; > 0
  Scalar coordinate = Scalar::float64;  ///< the type in which positions will be written
};

struct HandleResult {
  std::size_t removed = 0;
  std::size_t refused = 0;  ///< loops along which no two patches fit
  std::size_t blocked = 0;  ///< loops whose patches would reach into another part of the surface
  std::size_t new_vertices = 0, new_faces = 0;
  bool dropped_source_points = false;  ///< carry.h
};

HandleResult remove_handles(Mesh& mesh, const HandleOptions& options,
                            const Progress& progress = Progress());

}  // namespace transformesh

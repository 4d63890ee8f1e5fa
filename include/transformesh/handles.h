/// Removes thin handles: cuts through bridges and closes narrow tunnels, the shortest loop first.
/// The shape alone decides whether a loop goes around a bridge or a tunnel. Reference: Guskov &
/// Wood, "Topological noise removal", Graphics Interface 2001. Removes handles that noise, or thin
/// bridges between near parts, cause. Wide tunnels stay, and so do thin parts that are not handles.
/// Slits the surface along the loop (short_loops.h), moves both sides apart by a third of an edge
/// length, and closes each side by a patch (hole_patch.h).
///
/// Guarantees: the result is a closed oriented manifold with as many components as the input. Every
/// removed handle lowers the genus by one. Input vertices and faces stay, with order and columns;
/// only the vertices of loops move. New vertices and faces follow, with columns as in fill.h. The
/// surface may intersect itself at a slit; clean() resolves this. No patch intersects another
/// component, or the same component farther than two rings from the loop. No such component or part
/// lies between the two patches of a loop: cavities stay closed, and clean() keeps the components.
/// Deterministic for any number of threads.
///
/// Throws InputError if the mesh is not a closed oriented manifold, and UsageError if `max_length`
/// is not positive. Cost: that of short_loops() for each round, and O(n) for each handle.
#pragma once

#include <cstddef>

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct HandleOptions {
  double max_length = 0;  ///< largest length of the loop around a handle; input units; > 0
  Scalar coordinate = Scalar::float64;  ///< the type in which positions will be written
};

struct HandleResult {
  std::size_t removed = 0;
  std::size_t refused = 0;  ///< loops left uncut because no two patches fit
  std::size_t blocked = 0;  ///< loops left uncut because patches would touch other parts
  std::size_t new_vertices = 0, new_faces = 0;
  bool dropped_source_points = false;  ///< source points were dropped (carry.h)
};

HandleResult remove_handles(Mesh& mesh, const HandleOptions& options,
                            const Progress& progress = Progress());

}  // namespace transformesh

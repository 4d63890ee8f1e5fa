/// Relaxes the triangles of a closed surface to uniform shape.
#pragma once

#include <functional>

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh::shapes {

/// Alternates edge flips with smoothing. Flips prefer valence six in the first iterations and
/// larger angles afterwards. Smoothing moves every vertex to the center of its faces and back onto
/// the surface by `project`, which may be called from several threads. The mesh must be a closed
/// oriented manifold, and stays one with the same numbers of vertices and faces. O(n) per
/// iteration; deterministic.
void relax(Mesh& mesh, const std::function<Vec3(const Vec3&)>& project, int iterations,
           const Progress& progress);

}  // namespace transformesh::shapes

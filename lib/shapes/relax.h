/// Making the triangles of a closed surface even.
#pragma once

#include <functional>

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh::shapes {

/// Alternates edge flips, first towards valence six and then towards larger angles, with moving
/// every vertex to the middle of the faces around it and back onto the surface by `project`, which
/// may be called from several threads. The mesh must be a closed oriented manifold and stays one
/// with the same counts. O(n) per iteration; deterministic.
void relax(Mesh& mesh, const std::function<Vec3(const Vec3&)>& project, int iterations,
           const Progress& progress);

}  // namespace transformesh::shapes

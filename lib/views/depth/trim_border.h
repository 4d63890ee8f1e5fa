/// Removes narrow strips at the border of an open surface that was extracted from a grid. Also
/// makes the surface a manifold.
#pragma once

#include "transformesh/mesh.h"

namespace transformesh {

/// Removes parts that are narrower than about twice `rings` edges. Keeps a face if each of its
/// vertices is at most `rings` + 1 edges away from a vertex that is more than `rings` edges away
/// from the border. This is a morphological opening. Then keeps only the largest umbrella of each
/// vertex: its largest set of faces that are connected across edges. Every edge must have at most
/// two faces. O(faces); deterministic.
void trim_border(Mesh& mesh, int rings);

}  // namespace transformesh

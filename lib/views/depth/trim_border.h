/// Smooths the border of an open surface from a grid: removes fringes, and makes it a manifold.
#pragma once

#include "transformesh/mesh.h"

namespace transformesh {

/// Removes what is narrower than about twice `rings` edges: faces are kept if a vertex within
/// `rings` edges has a distance of at least `rings` edges from the border. This is an opening in
/// the sense of morphology. Then keeps only the largest umbrella of each vertex. Every edge must
/// have at most two faces. O(faces); deterministic.
void trim_border(Mesh& mesh, int rings);

}  // namespace transformesh

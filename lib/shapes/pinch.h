/// A surface pinched on its axis.
#pragma once

#include "transformesh/mesh.h"

namespace transformesh::shapes {

/// A surface of revolution about z whose profile passes through the axis once: two blobs, the upper
/// one with a negative radius, and between them a ring of faces that all contain the origin. The
/// vertices on either side of the ring are exact opposites, so hundreds of edges cross in one point
/// without any rounding.
Mesh pinch(std::size_t faces);

}  // namespace transformesh::shapes

/// A degenerate surface, pinched on its axis.
#pragma once

#include "transformesh/mesh.h"

namespace transformesh::shapes {

/// Returns a surface of revolution about z whose profile passes through the axis once. It consists
/// of two blobs below and above the origin. The upper one has a negative radius, so it is inside
/// out. Between them is a ring of faces that all contain the origin. The vertices on both sides of
/// the ring are exact opposites. Hundreds of edges therefore intersect in one point, without
/// rounding.
Mesh pinch(std::size_t faces);

}  // namespace transformesh::shapes

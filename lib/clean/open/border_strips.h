/// Finds thin strips of pieces along the border of an open component.
///
/// If a plane cuts two bodies that intersect, the borders of both lie in the plane up to rounding,
/// and they cross near the ends of the intersection curve. At each end one of the two borders is
/// above the other by a few spacings. Hence a curve that should reach both borders ends inside one
/// of the components. Pieces on both sides of the curve would stay connected through the strip
/// between its end and the border.
///
/// Reference: none. Cost: O(number of pieces). Deterministic; independent of the order of faces.
#pragma once

#include <vector>

#include "clean/arrange/arrange.h"
#include "mesh/edges.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// A piece of a strip, and a piece outside of strips that was connected to it.
struct StripSide {
  Index strip_piece, beside;
};

/// Finds the strips, and disconnects their pieces from all other pieces. A strip consists of pieces
/// of cut faces whose corners are all within 16 spacings of the same border edge. The spacing is
/// that of numbers of type `coordinate`. Edges shorter than this that end at the border connect no
/// pieces either. `connected` has, for every halfedge of a piece, the halfedge of the piece that is
/// connected to it across their edge, or `no_index`. Returns the disconnected pairs.
std::vector<StripSide> disconnect_border_strips(const Arrangement& arrangement, const Edges& edges,
                                                Scalar coordinate, std::vector<Index>& connected);

}  // namespace transformesh

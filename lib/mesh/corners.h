/// Indices of corners: 0, 1 and 2 of a face. Halfedge 3 * face + i goes from corner i to the next.
#pragma once

#include "transformesh/mesh.h"

namespace transformesh {

constexpr Index next_corner(Index i) { return i == 2 ? 0 : i + 1; }
constexpr Index previous_corner(Index i) { return i == 0 ? 2 : i - 1; }
constexpr Index next_edge(Index edge) { return edge / 3 * 3 + next_corner(edge % 3); }
constexpr Index previous_edge(Index edge) { return edge / 3 * 3 + previous_corner(edge % 3); }

}  // namespace transformesh

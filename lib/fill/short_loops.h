/// Finds short loops of edges around thin handles and around narrow tunnels. Cutting the surface
/// along such a loop does not separate it into two parts.
///
/// Each edge has a word, a 64-bit number (homology.h). A loop does not separate the surface if the
/// exclusive or of its words is not 0. Hence such a loop contains an edge with a nonzero word.
/// Shortest paths are grown from the ends of these edges. An edge between the ends of two paths
/// closes a loop. The shortest of all non-separating loops is among those found. Reference:
/// Erickson & Whittlesey, "Greedy optimal homotopy and homology generators", SODA 2005. Cost: for
/// each edge with a nonzero word, the number of vertices within half the length of the found loop,
/// or within half of `max_length`. Deterministic for any number of threads.
#pragma once

#include <vector>

#include "fill/halfedge_stars.h"
#include "fill/homology.h"
#include "transformesh/control.h"

namespace transformesh {

struct ShortLoop {
  /// Vertices in order along the loop; at least three, and all different.
  std::vector<Index> vertices;
  double length = 0;
  /// Exclusive or of the words of the edges of the loop (homology.h); not 0.
  HomologyWord word = 0;
};

/// Returns non-separating loops of at most `max_length`: at most one for each vertex at an edge
/// whose number in homology.h is not 0. The shortest loops come first; ties are decided by the
/// vertex indices.
std::vector<ShortLoop> short_loops(const Mesh& mesh, const HalfedgeStars& stars, double max_length,
                                   const Progress& progress = Progress());

}  // namespace transformesh

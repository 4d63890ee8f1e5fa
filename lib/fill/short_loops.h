/// Short non-separating loops of edges around thin handles and around narrow tunnels.
///
/// A non-separating loop contains an edge with a nonzero word (homology.h). Shortest paths are
/// grown from the ends of these edges. An edge between two paths with different words closes a
/// loop. The shortest of all loops is among those found. Reference: Erickson & Whittlesey, "Greedy
/// optimal homotopy and homology generators", SODA 2005. Cost: the number of edges with words,
/// times the size of a ball with half the length of the loop or of the limit. Deterministic for any
/// number of threads.
#pragma once

#include <vector>

#include "fill/halfedge_stars.h"
#include "fill/homology.h"
#include "transformesh/control.h"

namespace transformesh {

struct ShortLoop {
  std::vector<Index> vertices;  ///< distinct vertices in cyclic order; at least three
  double length = 0;
  HomologyWord word = 0;  ///< exclusive or of the words of its edges; not 0
};

/// Returns at most one loop per end of an edge with a word, of at most `max_length`. The shortest
/// loops come first; ties are decided by the vertex indices.
std::vector<ShortLoop> short_loops(const Mesh& mesh, const HalfedgeStars& stars, double max_length,
                                   const Progress& progress = Progress());

}  // namespace transformesh

/// Short loops of edges that do not separate a surface: around thin handles, and around the narrow
/// tunnels beside them.
/// A loop that does not separate passes an edge with a word (homology.h). From the ends of these
/// edges shortest paths are grown; an edge whose paths differ in their words closes a loop
/// (Erickson and Whittlesey, Greedy optimal homotopy and homology generators, SODA 2005). The
/// shortest one of all is among those found.
/// Cost: the edges with words, times the size of a ball of half the length of the loop found, or of
/// the limit. Deterministic for any number of threads.
#pragma once

#include <vector>

#include "fill/halfedge_stars.h"
#include "fill/homology.h"
#include "transformesh/control.h"

namespace transformesh {

struct ShortLoop {
  std::vector<Index> vertices;  ///< in order, each once; at least three
  double length = 0;
  HomologyWord word = 0;  ///< of all its edges; not 0
};

/// At most one for each such vertex, of at most that length; the shortest ones come first, of equal
/// ones that of the lower vertices.
std::vector<ShortLoop> short_loops(const Mesh& mesh, const HalfedgeStars& stars, double max_length,
                                   const Progress& progress = Progress());

}  // namespace transformesh

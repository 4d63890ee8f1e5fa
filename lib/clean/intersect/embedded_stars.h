/// Vertices whose faces meet nowhere but in corners and edges that they share, detected by
/// projection along an axis: where all faces around a vertex look the same way, each edge there has
/// two of them, and they go around once, their projections only touch. Of a smooth mesh these are
/// all vertices, so that no pair of neighbors needs to be tested. Reference: the condition on a
/// star in Volino & Magnenat-Thalmann, "Efficient self-collision detection on smoothly discretized
/// surface animations using geometrical shape regularity", Computer Graphics Forum 13(3), 1994.
#pragma once

#include <span>
#include <vector>

#include "clean/intersect/welded_mesh.h"

namespace transformesh {

/// Per point; what is marked is certain, what is not may be embedded all the same. O(n); parallel;
/// deterministic.
std::vector<char> find_embedded_stars(const WeldedMesh& welded);
/// Of those that are wanted.
std::vector<char> find_embedded_stars(const WeldedMesh& welded, std::span<const char> is_wanted);

/// Whether two faces share a vertex with such a star, and so meet in nothing but what they share.
/// Without branches, as chance decides.
inline bool share_embedded_star(const Face& f, const Face& g,
                                const std::vector<char>& is_embedded) {
  unsigned result = 0;
  for (const Index a : f) {
    const unsigned is_shared = unsigned{a == g[0]} | unsigned{a == g[1]} | unsigned{a == g[2]};
    result |= is_shared & static_cast<unsigned>(is_embedded[a]);
  }
  return result != 0;
}

}  // namespace transformesh

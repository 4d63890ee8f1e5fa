/// Detects vertices whose faces meet only in shared corners and edges, by projection along a
/// coordinate axis. The star of a vertex (all faces at the vertex) is embedded if three conditions
/// hold. All faces of the star have projections of the same orientation. Each of its edges has two
/// faces. The projected faces go around the vertex once. Typically this holds for all vertices of a
/// smooth mesh, and no pair of neighbors needs to be tested.
///
/// Reference: the condition on a star in Volino & Magnenat-Thalmann, "Efficient self-collision
/// detection on smoothly discretized surface animations using geometrical shape regularity",
/// Computer Graphics Forum 13(3), 1994. Here the directions of projection are the six axis
/// directions only.
#pragma once

#include <span>
#include <vector>

#include "clean/intersect/welded_mesh.h"

namespace transformesh {

/// Returns 1 for each point whose faces are proven to meet only in shared corners and edges. The
/// faces of a point with entry 0 may have this property, too. O(n) time; deterministic.
std::vector<char> find_embedded_stars(const WeldedMesh& welded);
/// Tests only the points with a nonzero `is_wanted` entry; the other points get 0.
std::vector<char> find_embedded_stars(const WeldedMesh& welded, std::span<const char> is_wanted);

/// True if two faces share a vertex that find_embedded_stars() marked. Such faces meet only in
/// shared corners and edges. The code has no branches because the outcome is unpredictable.
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

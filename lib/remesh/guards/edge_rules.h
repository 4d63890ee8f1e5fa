/// Lengths that the edges of a mesh are held to, and what collapses may do to its shape.
#pragma once

namespace transformesh {

/// How collapses treat the surface.
struct ShapeRules {
  bool curved = false;  ///< merged vertices lie at an end or on the curved edge (curved_edge.h)
  double min_film = 0;  ///< > 0: no collapse moves the surface by more than half of this; with 0
                        ///< and `curved`, by more than a share of the longest edge
};

/// Input units, or factors of the local size where the mesh has sizes.
struct EdgeLimits {
  double shortest = 0;
  double longest = 0;
  ShapeRules shape = {};

  /// Edges may become as long as this where that makes valences regular: a flip between equilateral
  /// triangles makes an edge of 1.73 of theirs, which relaxation shortens.
  double stretched() const { return 1.12 * longest; }
};

}  // namespace transformesh

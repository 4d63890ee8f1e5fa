/// Limits of edge lengths, and of the changes of shape by collapses.
#pragma once

namespace transformesh {

/// Limits for the change of the surface by collapses.
struct ShapeRules {
  bool curved = false;  ///< merged vertices lie at an end or on the curved edge (curved_edge.h)
  double min_film = 0;  ///< > 0: no collapse moves the surface by more than half of this; with 0
                        ///< and `curved`, by more than a share of the longest edge
};

/// Limits of edge lengths, in input units, or as factors of the local size if the mesh has sizes.
struct EdgeLimits {
  double shortest = 0;
  double longest = 0;
  ShapeRules shape = {};

  /// Longest edge that an operation may make if it brings valences closer to six. A flip of two
  /// equilateral triangles makes an edge 1.73 times as long as theirs, which relaxation shortens. A
  /// larger factor leaves longer edges; without it, many irregular valences stay.
  double stretched() const { return 1.12 * longest; }
};

}  // namespace transformesh

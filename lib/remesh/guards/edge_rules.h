/// Limits of edge lengths, and of the changes of shape by collapses.
#pragma once

namespace transformesh {

/// Limits for the change of the surface by collapses.
struct ShapeRules {
  /// A merged vertex lies at an end of the edge or on the curved edge (curved_edge.h).
  bool curved = false;
  /// > 0: no collapse moves the surface by more than half of this; 0 with `curved`: the limit is a
  /// share of the longest edge.
  double min_film = 0;
};

/// Limits of edge lengths, in input units, or as factors of the local size if the mesh has sizes.
struct EdgeLimits {
  double shortest = 0;
  double longest = 0;
  ShapeRules shape = {};

  /// Longest edge that an operation may make if it brings valences closer to six. The flip of an
  /// edge between two equilateral triangles makes it 1.73 times as long; relaxation then shortens
  /// it. A larger factor leaves longer edges; with the factor 1, many irregular valences stay.
  double stretched() const { return 1.12 * longest; }
};

}  // namespace transformesh

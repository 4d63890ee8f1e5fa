/// Lengths that the edges of a mesh are held to.
#pragma once

namespace transformesh {

/// Input units, or factors of the local size where the mesh has sizes.
struct EdgeLimits {
  double shortest = 0;
  double longest = 0;

  /// Edges may become as long as this where that makes valences regular: a flip between equilateral
  /// triangles makes an edge of 1.73 of theirs, which relaxation shortens.
  double stretched() const { return 1.12 * longest; }
};

}  // namespace transformesh

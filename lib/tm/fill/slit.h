/// A slit in a surface along a loop of edges: every vertex of the loop becomes two, one for the
/// faces on either side.
/// Cost: O(faces around the loop). Deterministic.
#pragma once

#include <utility>
#include <vector>

#include "tm/mesh/mesh.h"

namespace transformesh {

/// How to turn around the vertices of a closed oriented manifold.
class Surroundings {
 public:
  Surroundings(const Mesh& mesh, std::vector<Index> opposites);

  const std::vector<Index>& opposites() const { return opposites_; }
  /// The halfedges from a vertex, counter-clockwise, beginning with that to `first`, or with any.
  std::vector<Index> leaving(const Mesh& mesh, Index vertex, Index first = no_index) const;

 private:
  std::vector<Index> opposites_;  ///< of each halfedge
  std::vector<Index> leaving_;    ///< a halfedge from each vertex
};

/// What lies on one side of the loop, per vertex of it.
struct SlitSide {
  std::vector<std::vector<Index>> corners;  ///< 3 * face + corner, counter-clockwise
  /// Where it is drawn back to: a third of the way to the middle of the vertices next to it on this
  /// side; where it is, if there are none but those of the loop.
  std::vector<Vec3> drawn_back;
  std::vector<std::pair<Index, Index>> chords;  ///< edges between vertices of the loop, both ways
};

struct SlitSides {
  SlitSide left, right;
};

/// Pre: `loop` is a simple loop of edges, and since the surroundings were taken the faces at its
/// vertices are the same.
SlitSides sides_of(const Mesh& mesh, const std::vector<Index>& loop, const Surroundings& around);

/// Gives new vertices to the faces on the right: behind the others in the order of the loop, at the
/// same places and with the same columns.
void slit_along(Mesh& mesh, const std::vector<Index>& loop, const SlitSides& sides);

}  // namespace transformesh

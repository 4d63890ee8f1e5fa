/// Finds the components that pass through an edge of an open mesh, and the sides on which they pass
/// another component (docs/design/open-meshes.md, step 3). Cost: O(k log k) for k halfedges at the
/// edge. Deterministic.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "clean/arrange/arrange.h"
#include "clean/open/component_winding.h"

namespace transformesh {

/// A component with exactly two halfedges at an edge, in opposite directions.
struct Passage {
  Index component;
  /// Positions of the two halfedges in the angular order at the edge.
  std::size_t forward, backward;
};

struct Passages {
  std::vector<Passage> single;  ///< components that pass through the edge once
  std::vector<Index> multiple;  ///< components with several halfedges in both directions
};

/// Finds the passages at an edge. `sorted` has the halfedges in angular order. A forward piece has
/// its front towards the next piece in this order, and a backward piece has its front towards the
/// previous piece. A piece of coplanar faces belongs to the components of all of them.
Passages find_passages(const Arrangement& arrangement, const ComponentWinding& winding,
                       std::span<const Index> sorted);

struct FrontAndBack {
  Index front, back;
};

/// Returns the piece of component `one` in front of component `other`, and the piece behind it. A
/// piece of both components counts as in front if their faces have the same direction, and as
/// behind otherwise, because its front side is behind `other` then. Returns nothing if both pieces
/// of `one` are on the same side of `other`.
std::optional<FrontAndBack> sides_of(std::span<const Index> sorted, const Passage& one,
                                     const Passage& other);

}  // namespace transformesh

/// Bounds of the winding number of open components at their own surfaces, for all patches at once.
/// A patch is a connected set of pieces (triangles of cut faces) between intersection curves.
///
/// ComponentWinding computes such a number at one point in O(sqrt(m)). Most patches of a surface
/// that intersects itself often need no such computation. Inside a patch the number differs from
/// its value at one point by at most its gradient times the distance (border_gradient.h). At an
/// intersection curve, the numbers of all pieces differ by known multiples of 1/2, because each
/// piece is the boundary between winding numbers that differ by 1. Hence bounds are carried from
/// patch to patch until they are wide. Then the number is computed at one point of the next patch.
///
/// Numbers at a surface are means of both sides. Bounds contain the exact numbers; they depend on
/// the order of faces, so use them only for decisions that all numbers between them share.
/// Deterministic.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "clean/open/border_gradient.h"
#include "clean/open/component_winding.h"

namespace transformesh {

struct NumberBounds {
  double low, high;  ///< infinite if the patch touches a border
};

class OwnNumbers {
 public:
  /// Keeps references to both.
  OwnNumbers(const Arrangement& arrangement, ComponentWinding& winding);

  /// Records how the numbers of a component differ between its pieces at an edge. `sorted` has all
  /// halfedges of the edge in angular order. Does nothing if a piece at the edge may cover several
  /// faces.
  void add_edge(std::span<const Index> sorted, Index component);

  /// Returns the bounds of some patches of a component, as lists of pieces.
  std::vector<NumberBounds> bound(Index component,
                                  std::span<const std::vector<Index>* const> patches);

 private:
  /// The number at piece `to` is that at piece `from` plus `difference`, near the point `at`.
  struct Step {
    Index from, to;
    double difference;
    Vec3 at;
  };
  class Growth;

  const Arrangement& arrangement_;
  ComponentWinding& winding_;
  /// 1 for each point of a piece whose faces cancel out. Such pieces are not among the halfedges.
  std::vector<char> cancelled_;
  std::map<Index, std::vector<Step>> steps_;  ///< steps of each component
};

}  // namespace transformesh

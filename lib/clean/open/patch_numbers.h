/// Decides how many parts of an open mesh hide each of its patches (docs/design/open-meshes.md). A
/// patch is a connected set of pieces (triangles of cut faces) of one open component. Intersection
/// curves with other components are the borders between patches. A part hides a patch if the patch
/// is behind it, which means on the back side of its oriented faces.
///
/// Deterministic; independent of the order of faces. Cost: O(sqrt(m)) for each computed winding
/// number of a component with m faces; most patches of a component that intersects itself need none
/// (own_numbers.h).
#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "clean/open/component_winding.h"
#include "clean/open/own_numbers.h"

namespace transformesh {

/// The patches of a mesh, each named by one of its pieces, and how they are connected.
struct CutPatches {
  /// Total length of the curves along which a patch is in front of a component, and of those along
  /// which it is behind the component.
  struct Lengths {
    double front = 0, behind = 0;
  };
  std::map<Index, std::vector<Index>> pieces;         ///< pieces of each patch
  std::map<std::pair<Index, Index>, Lengths> curves;  ///< for each patch and component
  std::map<Index, std::set<Index>> intersecting;      ///< components that cut a component
  std::set<Index> self_intersecting;                  ///< components that cut themselves
};

class PatchNumbers {
 public:
  /// Keeps references to all of them.
  PatchNumbers(const CutPatches& patches, ComponentWinding& winding, OwnNumbers& own_numbers);

  struct Number {
    int count = 0;               ///< number of parts that hide the patch
    bool is_by_winding = false;  ///< true if generalized winding numbers were needed
  };
  Number hiding(Index patch);
  /// Returns the least distance of a used winding number from the nearest value at which it would
  /// be rounded otherwise, or 1/2. Call it after the last call of hiding().
  double least_margin();

 private:
  /// A winding number less `shift` was rounded by its bounds. Its distance from the nearest value
  /// at which it would be rounded otherwise is at least `margin`.
  struct RoundedByBounds {
    double margin, shift;
    Index patch;
  };

  Index component(Index patch) const { return winding_.component_of(patch); }
  bool is_behind(Index patch, Index other);
  int count_others(Index patch);
  int count_own(Index patch);
  int round(double number);

  const CutPatches& patches_;
  ComponentWinding& winding_;
  /// For each patch of a component that intersects itself.
  std::map<Index, NumberBounds> own_bounds_;
  std::vector<RoundedByBounds> by_bounds_;
  double least_margin_ = 0.5;
  bool is_by_winding_ = false;  ///< true if the current patch needed a winding number
};

}  // namespace transformesh

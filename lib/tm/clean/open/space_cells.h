/// The cells into which the patches of an arrangement part space, and the winding number in each,
/// as far as patches agree on it. Cost: O(n log n). Deterministic.
#pragma once

#include <vector>

#include "tm/clean/exterior/patches.h"
#include "tm/mesh/disjoint_sets.h"

namespace transformesh {

class SpaceCells {
 public:
  /// Those of the patches that are marked part nothing.
  SpaceCells(const Arrangement& arrangement, const Patches& patches,
             const std::vector<char>& is_transparent);

  /// In a cell without bounds of a connected set of patches w is 0. From there it passes through
  /// patches to the next cells, to each along the shortest ways, of which the largest w counts.
  int winding_in_front_of(Index patch) const { return winding_[cell_of_[std::size_t{2} * patch]]; }
  int winding_behind(Index patch) const { return winding_[cell_of_[std::size_t{2} * patch + 1]]; }

 private:
  void join_around_edges(const Arrangement& arrangement, const Patches& patches,
                         DisjointSets& sides) const;
  std::vector<double> volumes(const Arrangement& arrangement, const Patches& patches) const;
  std::vector<Index> unbounded_cells(const std::vector<double>& volumes) const;
  void spread_winding(const Arrangement& arrangement, const Patches& patches);

  std::vector<Index> cell_of_;  ///< of the front of each patch, and of its back
  std::vector<int> winding_;    ///< of cells
};

}  // namespace transformesh

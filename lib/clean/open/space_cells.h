/// The cells into which the patches of an arrangement (exterior/patches.h) divide space, with a
/// winding number for each cell. Cost: O(n log n). Deterministic. Reference: Zhou, Grinspun, Zorin
/// & Jacobson, "Mesh arrangements for solid geometry", ACM TOG 35(4), 2016. Departure: two paths
/// between cells may give different winding numbers, because the mesh may be open.
#pragma once

#include <vector>

#include "clean/exterior/patches.h"

namespace transformesh {

class SpaceCells {
 public:
  /// Patches with a nonzero `is_transparent` entry are ignored: the cells on both sides count as
  /// one.
  SpaceCells(const Arrangement& arrangement, const Patches& patches,
             const std::vector<char>& is_transparent);

  /// Returns the winding number of the cell in front of a patch. The unbounded cell of each
  /// connected set of patches has 0. Other cells get their winding number along shortest paths from
  /// cell to cell. If several shortest paths disagree, the largest value counts.
  int winding_in_front_of(Index patch) const { return winding_[cell_of_[std::size_t{2} * patch]]; }
  int winding_behind(Index patch) const { return winding_[cell_of_[std::size_t{2} * patch + 1]]; }

 private:
  std::vector<double> volumes(const Arrangement& arrangement, const Patches& patches) const;
  std::vector<Index> unbounded_cells(const std::vector<double>& volumes) const;
  void spread_winding(const Arrangement& arrangement, const Patches& patches);

  std::vector<Index>
      /// Entry 2 * patch is the cell in front of a patch, entry 2 * patch + 1 the cell behind it.
      cell_of_;
  /// Winding number per cell; the index of a cell is the index of one of its patch sides.
  std::vector<int> winding_;
};

}  // namespace transformesh

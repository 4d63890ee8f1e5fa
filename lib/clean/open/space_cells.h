/// The cells into which the patches of an arrangement divide space, with their winding numbers if
/// the patches are consistent. Cost: O(n log n). Deterministic. Reference: Zhou, Grinspun, Zorin &
/// Jacobson, "Mesh arrangements for solid geometry", ACM TOG 35(4), 2016. There the patches are
/// always consistent; here they need not be.
#pragma once

#include <vector>

#include "clean/exterior/patches.h"

namespace transformesh {

class SpaceCells {
 public:
  /// Patches marked in `is_transparent` do not separate cells.
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
      cell_of_;  ///< cell in front of a patch at 2 * patch, cell behind it at 2 * patch + 1
  std::vector<int> winding_;  ///< per cell; a cell has the number of one of its sides
};

}  // namespace transformesh

/// The cells into which the patches of an arrangement part space, and the winding number in each,
/// as far as patches agree on it. Cost: O(n log n). Deterministic. Reference: Zhou, Grinspun, Zorin
/// & Jacobson, "Mesh arrangements for solid geometry", ACM TOG 35(4), 2016; there winding numbers
/// always agree.
#pragma once

#include <vector>

#include "clean/exterior/patches.h"

namespace transformesh {

class SpaceCells {
 public:
  /// Patches that are marked as transparent part nothing.
  SpaceCells(const Arrangement& arrangement, const Patches& patches,
             const std::vector<char>& is_transparent);

  /// The winding number in the cell on that side of the patch. It is 0 in the unbounded cell of
  /// each connected set of patches. From there it passes through patches from cell to cell, to each
  /// along the shortest ways; where these disagree, the largest counts.
  int winding_in_front_of(Index patch) const { return winding_[cell_of_[std::size_t{2} * patch]]; }
  int winding_behind(Index patch) const { return winding_[cell_of_[std::size_t{2} * patch + 1]]; }

 private:
  std::vector<double> volumes(const Arrangement& arrangement, const Patches& patches) const;
  std::vector<Index> unbounded_cells(const std::vector<double>& volumes) const;
  void spread_winding(const Arrangement& arrangement, const Patches& patches);

  std::vector<Index>
      cell_of_;               ///< at 2 * patch the cell in front of it, at 2 * patch + 1 behind it
  std::vector<int> winding_;  ///< per cell; cells are named by one of their sides of patches
};

}  // namespace transformesh

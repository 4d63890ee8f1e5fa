/// Hash table of points by the cells of a uniform grid, for finding points near a position in
/// constant time. Points are visited cell by cell, in the order in which they were added. Hence
/// results do not depend on hashing.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "support/random.h"
#include "transformesh/mesh.h"

namespace transformesh {

class HashedGrid {
 public:
  /// Creates an empty grid. `width` is the side length of its cubic cells.
  explicit HashedGrid(double width) : width_(width) {}

  void add(const Vec3& position, Index point) { cells_[cell_of(position)].push_back(point); }

  /// Calls visit(point) for the points in the cell of the position and in the 26 cells around this
  /// cell, until `visit` returns true. These include all points within `width` along each axis.
  /// Returns true if `visit` did.
  template <class Visit>
  bool find_around(const Vec3& position, const Visit& visit) const {
    const Cell cell = cell_of(position);
    for (int i = 0; i < 27; ++i) {
      // Start with the cell of the position, number 13.
      const auto found = cells_.find(neighbor(cell, (i + 13) % 27));
      if (found == cells_.end()) continue;
      for (const Index point : found->second)
        if (visit(point)) return true;
    }
    return false;
  }

 private:
  /// Cell indices as whole numbers in doubles, which may exceed the range of integer types.
  using Cell = std::array<double, 3>;

  struct Hash {
    std::size_t operator()(const Cell& cell) const {
      std::uint64_t word = 0;
      for (const double number : cell) word = mixed(word ^ std::bit_cast<std::uint64_t>(number));
      return word;
    }
  };

  // Returns the cell of a position. Adding 0 turns -0 into 0, so that equal cells have equal bits.
  Cell cell_of(const Vec3& p) const {
    return {std::floor(p[0] / width_) + 0.0, std::floor(p[1] / width_) + 0.0,
            std::floor(p[2] / width_) + 0.0};
  }
  /// Returns neighbor i, in [0, 27), of a cell. Number 13 is the cell itself.
  static Cell neighbor(const Cell& cell, int i) {
    return {cell[0] + (i % 3 - 1), cell[1] + (i / 3 % 3 - 1), cell[2] + (i / 9 - 1)};
  }

  double width_;
  std::unordered_map<Cell, std::vector<Index>, Hash> cells_;
};

}  // namespace transformesh

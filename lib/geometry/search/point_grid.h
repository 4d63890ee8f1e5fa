/// Points by the cells of a regular grid, to find those near a position and those in one place.
/// Cells are visited in order, so results do not depend on hashing. Cost: O(log n) for each cell
/// that is looked up.
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

class PointGrid {
 public:
  /// Cells are cubes of that width.
  explicit PointGrid(double width) : width_(width) {}

  void add(const Vec3& position, Index point) { cells_[cell_of(position)].push_back(point); }

  /// Calls visit(point) for the points in the cell of the position and in the 26 cells around it:
  /// so for all that are as near as the width along every axis.
  template <class Visit>
  void visit_around(const Vec3& position, const Visit& visit) const {
    const Cell cell = cell_of(position);
    for (int i = 0; i < 27; ++i) {
      const auto found = cells_.find(neighbor(cell, i));
      if (found == cells_.end()) continue;
      for (const Index point : found->second) visit(point);
    }
  }

  /// Calls visit(points) for the points of every cell that has any, in the order they were added.
  template <class Visit>
  void visit_cells(const Visit& visit) const {
    for (const auto& [cell, points] : cells_) visit(points);
  }

  /// Calls visit(points, points) once for every two cells that have points and share a corner.
  template <class Visit>
  void visit_adjacent_cells(const Visit& visit) const {
    for (const auto& [cell, points] : cells_) {
      for (int i = 0; i < 13; ++i) {  // the cell comes in the other half of its neighbors' 26
        const auto found = cells_.find(neighbor(cell, i));
        if (found != cells_.end()) visit(points, found->second);
      }
    }
  }

 private:
  using Cell = std::array<double, 3>;  ///< whole numbers, beyond the range of integers too

  Cell cell_of(const Vec3& p) const {
    return {std::floor(p[0] / width_), std::floor(p[1] / width_), std::floor(p[2] / width_)};
  }
  /// The i-th of the 27 cells around one, of which the 13th is the cell itself.
  static Cell neighbor(const Cell& cell, int i) {
    const std::array<int, 3> offset{i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
    return {cell[0] + offset[0], cell[1] + offset[1], cell[2] + offset[2]};
  }

  double width_;
  std::map<Cell, std::vector<Index>> cells_;
};

}  // namespace transformesh

/// The cells of a grid of cubes that triangles touch, and marks of cells. Triangles that come near
/// each other have a cell in common; long triangles are cut into short ones first, so that far from
/// them few others have. Deterministic.
#pragma once

#include <span>
#include <vector>

#include "mesh/triangle.h"

namespace transformesh {

using Cell = std::uint64_t;

class CellGrid {
 public:
  explicit CellGrid(double size) : size_(size) {}

  /// Cells touched by what is as near as `margin` to a triangle, and some others beside them, in a
  /// list that is cleared before. Some come twice. Cost: O(1) for a triangle smaller than a cell.
  void find(const Triangle& triangle, double margin, std::vector<Cell>& cells) const;
  double size() const { return size_; }
  /// The cell as a box, but for rounding, and a box that is a little larger.
  Eigen::AlignedBox3d box_of(Cell cell) const;
  Eigen::AlignedBox3d box_around(Cell cell) const;

 private:
  using Corners = std::array<std::array<double, 3>, 3>;  ///< corners of a triangle, in cells
  static void add(const Corners& corners, double margin, std::vector<Cell>& cells);
  static void add_halves(const Corners& corners, double margin, std::vector<Cell>& cells);

  double size_;
};

/// Collects what decides on the size of cells.
class CellSize {
 public:
  void add(const Triangle& triangle);
  const Eigen::AlignedBox3d& bounds() const { return bounds_; }
  /// Returns the mean length of the boxes around the triangles, but at least a 256th of the longest
  /// side of the box around all. Larger cells bring more neighbors, smaller ones take more memory.
  double size() const;
  /// The least size of cells for these triangles.
  double least() const;

 private:
  Eigen::AlignedBox3d bounds_;
  double mean_ = 0;
  std::size_t count_ = 0;
};

/// Marks of cells: pairs of a cell and a number, each once, with the round in which it was made.
/// Cost: O(1) to add or find a pair; 32 to 64 bytes for each.
class CellMarks {
 public:
  /// Returns false if the pair was marked before.
  bool add(Cell cell, Index number, Index round = 0);
  /// Calls visit(number) for the marks of a cell that were made before a round, until it returns
  /// true; returns whether it did.
  template <class Visit>
  bool visit(Cell cell, Index round, const Visit& visit) const {
    if (slots_.empty()) return false;
    for (std::size_t at = first_slot(cell); slots_[at].number != no_index; at = next(at))
      if (slots_[at].cell == cell && slots_[at].round < round && visit(slots_[at].number))
        return true;
    return false;
  }
  bool has(Cell cell) const {
    return visit(cell, no_index, [](Index) { return true; });
  }

 private:
  struct Slot {
    Cell cell = 0;
    Index number = no_index;
    Index round = 0;
  };

  std::size_t first_slot(Cell cell) const;
  std::size_t next(std::size_t at) const { return (at + 1) & (slots_.size() - 1); }
  void grow();

  std::vector<Slot> slots_;
  std::size_t used_ = 0;
};

}  // namespace transformesh

/// Uniform grid of cubic cells: finds the cells that triangles touch, and stores marks of cells.
/// Two triangles that are close to each other share a cell. Long triangles are subdivided first, so
/// that they do not share cells with distant triangles. Deterministic.
#pragma once

#include <span>
#include <vector>

#include "mesh/triangle.h"

namespace transformesh {

using Cell = std::uint64_t;

class CellGrid {
 public:
  explicit CellGrid(double size) : size_(size) {}

  /// Stores in `cells` the cells within `margin` of a triangle, and some adjacent cells. The list
  /// may contain duplicates. Cost: O(1) for a triangle smaller than a cell.
  void find(const Triangle& triangle, double margin, std::vector<Cell>& cells) const;
  double size() const { return size_; }
  /// Returns the box of a cell, up to rounding. The function box_around() returns a slightly larger
  /// box that certainly contains the cell.
  Eigen::AlignedBox3d box_of(Cell cell) const;
  Eigen::AlignedBox3d box_around(Cell cell) const;

 private:
  /// Corners of a triangle, with coordinates in units of the cell size.
  using Corners = std::array<std::array<double, 3>, 3>;
  static void add(const Corners& corners, double margin, std::vector<Cell>& cells);
  static void add_halves(const Corners& corners, double margin, std::vector<Cell>& cells);

  double size_;
};

/// Determines the cell size from the triangles of a mesh.
class CellSize {
 public:
  void add(const Triangle& triangle);
  const Eigen::AlignedBox3d& bounds() const { return bounds_; }
  /// Returns the cell size: the mean of the longest sides of the bounding boxes of the triangles,
  /// but at least 1/256 of the longest side of the mesh. Larger cells contain more faces; smaller
  /// cells take more memory.
  double size() const;
  /// Returns the smallest valid cell size for the added triangles.
  double least() const;

 private:
  Eigen::AlignedBox3d bounds_;
  double mean_ = 0;
  std::size_t count_ = 0;
};

/// Set of marks. A mark is a pair of a cell and a number, with the round in which the pair was
/// added. Cost: O(1) to add or find a pair; 32 to 64 bytes per pair.
class CellMarks {
 public:
  /// Adds the pair of a cell and a number. Returns false if the pair exists already.
  bool add(Cell cell, Index number, Index round = 0);
  /// Calls visit(number) for the marks of a cell that were added before `round`, until `visit`
  /// returns true. Returns true if `visit` did.
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

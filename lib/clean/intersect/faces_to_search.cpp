#include "clean/intersect/faces_to_search.h"

#include <algorithm>

#include "clean/intersect/corner_cells.h"

namespace transformesh {
namespace {

/// Large faces together may cover at most this number of cells per face of the mesh; otherwise no
/// face is left out. The grid has about as many cells as the mesh has faces. This choice bounds
/// time.
constexpr std::size_t most_cells_per_face = 16;
/// RegionGrid adds a margin of two cells. The sum, 255, fits into a byte.
constexpr unsigned most_cells_per_axis = 253;
constexpr Index several = no_index - 1;  ///< marks a cell with faces of several regions or of none

std::vector<Index> first_copies(const WeldedMesh& welded) {
  std::vector<Index> firsts;
  firsts.reserve(welded.faces.size());
  for (Index f = 0; f < welded.faces.size(); ++f) {
    if (welded.first_copy[f] == f) firsts.push_back(f);
  }
  return firsts;
}

unsigned cells_per_axis(std::size_t cells) {
  unsigned side = 2;
  while (side < most_cells_per_axis && std::size_t{side} * side * side < cells) ++side;
  return side;
}

/// True if a face covers at most two cells along each axis.
bool is_usual(const CellRange& range) {
  unsigned most = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    most = std::max(most, static_cast<unsigned>(range.high[axis] - range.low[axis]));
  return most <= 1;
}

/// For each grid cell the region of its faces. A usual face is entered into its lowest cell only.
/// If two usual faces share a cell, their lowest cells are equal or adjacent.
class RegionGrid {
 public:
  explicit RegionGrid(unsigned per_axis)
      : side_(per_axis + 2), region_at_(std::size_t{side_} * side_ * side_, no_index) {}

  Index cell(std::size_t x, std::size_t y, std::size_t z) const {
    return static_cast<Index>(((x + 1) * side_ + y + 1) * side_ + z + 1);
  }
  Index lowest_cell(const CellRange& range) const {
    return cell(range.low[0], range.low[1], range.low[2]);
  }

  void enter(Index cell, Index region) {
    Index& at = region_at_[cell];
    if (at == no_index) occupied_.push_back(cell);
    at = at == no_index || at == region ? region : several;
  }
  void enter_large(const CellRange& range) {
    for (std::size_t x = range.low[0]; x <= range.high[0]; ++x)
      for (std::size_t y = range.low[1]; y <= range.high[1]; ++y)
        for (std::size_t z = range.low[2]; z <= range.high[2]; ++z) enter(cell(x, y, z), several);
  }

  /// Marks the cells that have faces of several regions in the cell itself or in an adjacent cell.
  std::vector<char> find_crowded() const {
    std::vector<char> is_crowded(region_at_.size(), 0);
    for (const Index cell : occupied_) {
      const Index region = region_at_[cell];
      bool found = region == several;
      for (const std::size_t x : {cell - side_ * side_, cell + 0U, cell + side_ * side_})
        for (const std::size_t y : {x - side_, x, x + side_})
          for (const std::size_t z : {y - 1, y, y + 1})
            found |= region_at_[z] != no_index && region_at_[z] != region;
      is_crowded[cell] = found ? 1 : 0;
    }
    return is_crowded;
  }

 private:
  Index side_;  ///< cells per axis, including a margin of one cell at each end
  std::vector<Index> region_at_;
  std::vector<Index> occupied_;
};

}  // namespace

std::vector<Index> find_faces_to_search(const WeldedMesh& welded, std::span<const Index> regions) {
  std::vector<Index> faces = first_copies(welded);
  const auto count = static_cast<std::size_t>(std::count(regions.begin(), regions.end(), no_index));
  if (count > regions.size() / 2) return faces;
  const unsigned per_axis = cells_per_axis(faces.size());
  const CornerCells cells(welded.points, per_axis);
  if (!cells.is_usable()) return faces;

  RegionGrid grid(per_axis);
  std::vector<Index> cell_of(faces.size(), no_index);  // lowest cell; no_index for large faces
  std::size_t cells_left = most_cells_per_face * faces.size();
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const CellRange range = cells.around(welded.faces[faces[i]]);
    if (is_usual(range)) {
      cell_of[i] = grid.lowest_cell(range);
      grid.enter(cell_of[i], regions[faces[i]] == no_index ? several : regions[faces[i]]);
    } else {
      if (range.size() > cells_left) return faces;
      cells_left -= range.size();
      grid.enter_large(range);
    }
  }
  const std::vector<char> is_crowded = grid.find_crowded();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    faces[kept] = faces[i];
    kept += cell_of[i] == no_index || is_crowded[cell_of[i]] ? 1 : 0;
  }
  faces.resize(kept);
  return faces;
}

}  // namespace transformesh

#include "clean/intersect/faces_to_search.h"

#include <algorithm>
#include <atomic>

#include "clean/intersect/corner_cells.h"
#include "support/numbered_selection.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

/// Limit on the number of grid cells that all large faces together cover, divided by the number of
/// faces of the mesh. If the limit is exceeded, all faces are searched. The grid has about as many
/// cells as the mesh has faces. This choice bounds time.
constexpr std::size_t most_cells_per_face = 16;
/// Largest number of cells along an axis, without the two cells that RegionGrid adds as a margin.
/// The sum, 255, fits into a byte.
constexpr unsigned most_cells_per_axis = 253;
/// Marks a cell that has faces of several intersection-free regions, or a face outside such
/// regions.
constexpr Index several = no_index - 1;

RawVector<Index> first_copies(const WeldedMesh& welded) {
  if (!welded.has_copies) {
    RawVector<Index> all(welded.faces.size());
    parallel_for_each(all.size(), [&](Index f) { all[f] = f; });
    return all;
  }
  return NumberedSelection(welded.faces.size(),
                           [&](std::size_t f) { return welded.first_copy[f] == f; })
      .list();
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

/// Stores for each grid cell the intersection-free region of its faces. A face that is_usual()
/// accepts is entered only into its cell with the lowest coordinates. If two such faces share a
/// cell, their lowest cells are equal or adjacent.
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

  /// Enters a face into a cell. `region` is the region of the face, or `several`. The result does
  /// not depend on the order of the calls.
  void enter(Index cell, Index region) {
    const std::atomic_ref at(region_at_[cell]);
    Index known = at.load(std::memory_order_relaxed);
    while (known != region && known != several) {
      const Index wanted = known == no_index ? region : several;
      if (at.compare_exchange_weak(known, wanted, std::memory_order_relaxed)) return;
    }
  }
  void enter_large(const CellRange& range) {
    for (std::size_t x = range.low[0]; x <= range.high[0]; ++x)
      for (std::size_t y = range.low[1]; y <= range.high[1]; ++y)
        for (std::size_t z = range.low[2]; z <= range.high[2]; ++z) enter(cell(x, y, z), several);
  }

  /// Marks the cells that have faces of several regions in the cell itself or in an adjacent cell.
  std::vector<char> find_crowded() const {
    std::vector<char> is_crowded(region_at_.size(), 0);
    parallel_for_each(region_at_.size(), [&](Index cell) {
      const Index region = region_at_[cell];
      if (region == no_index) return;
      bool found = region == several;
      for (const std::size_t x : {cell - side_ * side_, cell + 0U, cell + side_ * side_})
        for (const std::size_t y : {x - side_, x, x + side_})
          for (const std::size_t z : {y - 1, y, y + 1})
            found |= region_at_[z] != no_index && region_at_[z] != region;
      is_crowded[cell] = found ? 1 : 0;
    });
    return is_crowded;
  }

 private:
  Index side_;  ///< cells per axis, including a margin of one cell at each end
  std::vector<Index> region_at_;
};

}  // namespace

RawVector<Index> find_faces_to_search(const WeldedMesh& welded, std::span<const Index> regions) {
  RawVector<Index> faces = first_copies(welded);
  const std::size_t without = NumberedSelection(regions.size(), [&](std::size_t f) {
                                return regions[f] == no_index;
                              }).size();
  if (without > regions.size() / 2) return faces;
  const unsigned per_axis = cells_per_axis(faces.size());
  const CornerCells cells(welded.points, per_axis);
  if (!cells.is_usable()) return faces;

  RegionGrid grid(per_axis);
  // Lowest cell of each face; no_index if it covers more than two cells per axis.
  RawVector<Index> cell_of(faces.size());
  const NumberedSelection large(faces.size(), [&](std::size_t i) {
    const CellRange range = cells.around(welded.faces[faces[i]]);
    cell_of[i] = is_usual(range) ? grid.lowest_cell(range) : no_index;
    const Index region = regions[faces[i]];
    if (cell_of[i] != no_index) grid.enter(cell_of[i], region == no_index ? several : region);
    return cell_of[i] == no_index;
  });
  std::size_t cells_left = most_cells_per_face * faces.size();
  for (const Index i : large.list()) {
    const CellRange range = cells.around(welded.faces[faces[i]]);
    if (range.size() > cells_left) return faces;
    cells_left -= range.size();
    grid.enter_large(range);
  }
  const std::vector<char> is_crowded = grid.find_crowded();
  const NumberedSelection kept(faces.size(), [&](std::size_t i) {
    return cell_of[i] == no_index || is_crowded[cell_of[i]] != 0;
  });
  RawVector<Index> result(kept.size());
  kept.visit([&](std::size_t i, std::size_t n) { result[n] = faces[i]; });
  return result;
}

}  // namespace transformesh

#include "geometry/search/cell_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace transformesh {
namespace {

/// Largest number of cells on each side of the origin along an axis, so that the cell index has 63
/// bits.
constexpr double most_cells = 1 << 20;
/// Number of cells along the longest side of a mesh. With 512, the marks (CellMarks) of all tiles
/// take two to four times the memory and time. With 128, the halos of 64 tiles (the faces around
/// the parts that are cleaned alone) are twice as wide.
constexpr double cells_per_side = 256;

std::array<Vec3, 2> corners_of(const Triangle& t) {
  return {t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2])};
}

double length_of(const std::array<Vec3, 2>& corners) {
  return 2 * (corners[1] / 2 - corners[0] / 2).maxCoeff();
}

}  // namespace

// Shift coordinates so that, in units of cells, they are positive relative to the first cell. Then
// truncation gives the cell indices.
void CellGrid::find(const Triangle& triangle, double margin, std::vector<Cell>& cells) const {
  // A margin that exceeds the rounding error of coordinates in units of cells, which is below
  // 2^-31.
  constexpr double rounding = 0x1p-20;
  cells.clear();
  Corners corners;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      corners[i][k] = std::clamp(triangle[i][static_cast<Eigen::Index>(k)] / size_ + most_cells,
                                 1.0, 2 * most_cells - 2);
  add(corners, std::min(margin / size_ + rounding, 1.0), cells);
}

void CellGrid::add(const Corners& t, double margin, std::vector<Cell>& cells) {
  std::array<std::uint64_t, 3> low, high;
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [least, most] = std::minmax({t[0][k], t[1][k], t[2][k]});
    longest = std::max(longest, most - least);
    low[k] = static_cast<std::uint64_t>(least - margin);
    high[k] = static_cast<std::uint64_t>(most + margin);
  }
  if (longest > 1) return add_halves(t, margin, cells);
  for (Cell x = low[0]; x <= high[0]; ++x)
    for (Cell y = low[1]; y <= high[1]; ++y)
      for (Cell z = low[2]; z <= high[2]; ++z) cells.push_back(x << 42 | y << 21 | z);
}

// Splits the triangle at the midpoint of its longest edge, and adds the cells of both halves.
void CellGrid::add_halves(const Corners& t, double margin, std::vector<Cell>& cells) {
  std::size_t longest = 0;
  double most = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto &from = t[i], &to = t[(i + 1) % 3];
    const double length =
        std::max({std::abs(to[0] - from[0]), std::abs(to[1] - from[1]), std::abs(to[2] - from[2])});
    if (length > most) longest = i;
    most = std::max(most, length);
  }
  const auto &a = t[longest], &b = t[(longest + 1) % 3], &c = t[(longest + 2) % 3];
  const std::array<double, 3> middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
  add({a, middle, c}, margin, cells);
  add({middle, b, c}, margin, cells);
}

Eigen::AlignedBox3d CellGrid::box_of(Cell cell) const {
  constexpr Cell mask = (Cell{1} << 21) - 1;
  const Vec3 place(static_cast<double>(cell >> 42), static_cast<double>(cell >> 21 & mask),
                   static_cast<double>(cell & mask));
  const Vec3 low = place.array() - most_cells;
  return {size_ * low, size_ * (low.array() + 1)};
}

Eigen::AlignedBox3d CellGrid::box_around(Cell cell) const {
  // Enlarge the box by a hundredth of a cell, which exceeds the rounding error of its sides.
  const Vec3 margin = Vec3::Constant(size_ / 100);
  const Eigen::AlignedBox3d box = box_of(cell);
  return {box.min() - margin, box.max() + margin};
}

void CellSize::add(const Triangle& triangle) {
  const std::array<Vec3, 2> corners = corners_of(triangle);
  bounds_.extend(corners[0]);
  bounds_.extend(corners[1]);
  ++count_;
  mean_ += (length_of(corners) - mean_) / static_cast<double>(count_);
}

double CellSize::size() const {
  return std::min(std::max(mean_, least()), std::numeric_limits<double>::max());
}

double CellSize::least() const {
  const double side = (bounds_.max() / 2 - bounds_.min() / 2).maxCoeff() * 2;
  const double farthest =
      std::max(bounds_.min().cwiseAbs().maxCoeff(), bounds_.max().cwiseAbs().maxCoeff());
  return std::max(
      {side / cells_per_side, farthest / most_cells * 2, std::numeric_limits<double>::min()});
}

bool CellMarks::add(Cell cell, Index number, Index round) {
  if (2 * used_ >= slots_.size()) grow();
  std::size_t at = first_slot(cell);
  for (; slots_[at].number != no_index; at = next(at))
    if (slots_[at].cell == cell && slots_[at].number == number) return false;
  slots_[at] = {cell, number, round};
  ++used_;
  return true;
}

std::size_t CellMarks::first_slot(Cell cell) const {
  const Cell mixed = (cell ^ cell >> 29) * 0x9e3779b97f4a7c15U;
  return static_cast<std::size_t>(mixed ^ mixed >> 32) & (slots_.size() - 1);
}

void CellMarks::grow() {
  const std::vector<Slot> old =
      std::exchange(slots_, std::vector<Slot>(std::max(std::size_t{1024}, 2 * slots_.size())));
  for (const Slot& slot : old) {
    if (slot.number == no_index) continue;
    std::size_t at = first_slot(slot.cell);
    while (slots_[at].number != no_index) at = next(at);
    slots_[at] = slot;
  }
}

}  // namespace transformesh

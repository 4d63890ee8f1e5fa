#include "clean/exterior/local_references.h"

#include <algorithm>
#include <array>

#include "geometry/axis_path.h"

namespace transformesh {
namespace {

/// Number of points that are tried in a cell. A point is rejected if the path to it touches an edge
/// of the mesh. This happens only by coincidence, so a second point is rarely needed. Exception: a
/// cell that is only a few coordinate spacings wide.
constexpr int points_per_cell = 16;

/// Returns the cells that share a side with a cell.
std::array<Cell, 6> neighbors_of(Cell cell) {
  constexpr Cell x = Cell{1} << 42, y = Cell{1} << 21, z = 1;
  return {cell - x, cell + x, cell - y, cell + y, cell - z, cell + z};
}

/// Returns the central cube of a cell. The width of the cube is half the width of the cell.
Eigen::AlignedBox3d core_of(const CellGrid& grid, Cell cell) {
  const Eigen::AlignedBox3d box = grid.box_of(cell);
  const Vec3 quarter = Vec3::Constant(grid.size() / 4);
  return {box.min() + quarter, box.max() - quarter};
}

}  // namespace

std::optional<ReferencePoint> LocalReferences::near(const Vec3& place, int attempt) const {
  std::vector<Cell> cells;
  around_.grid.find({place, place, place}, 0, cells);
  const std::lock_guard lock(mutex_);
  for (const Cell cell : cells) {
    if (!around_.covered.has(cell)) continue;
    std::optional<ReferencePoint> first = known(cell);
    if (!first || attempt == 0) return first;
    return find_in(core_of(around_.grid, cell), attempt * points_per_cell, *first);
  }
  return std::nullopt;
}

std::optional<ReferencePoint> LocalReferences::known(Cell cell) const {
  std::optional<ReferencePoint> last;
  for (const Cell next : way_to(cell)) {
    const auto found = known_.find(next);
    last = found != known_.end() ? found->second : find_in(core_of(around_.grid, next), 0, *last);
    if (!last) return std::nullopt;
    known_.emplace(next, *last);
  }
  return last;
}

// Returns a path of adjacent grid cells that ends in `cell`. The path starts in a cell that
// contains a point with known winding number. The breadth-first search runs backwards, from `cell`.
std::vector<Cell> LocalReferences::way_to(Cell cell) const {
  std::unordered_map<Cell, Cell> towards{{cell, cell}};
  std::vector<Cell> queue{cell};
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Cell at = queue[i];
    if (known_.contains(at) || enter(at)) {
      std::vector<Cell> way{at};
      while (way.back() != cell) way.push_back(towards.at(way.back()));
      return way;
    }
    for (const Cell next : neighbors_of(at))
      if (around_.covered.has(next) && towards.emplace(next, at).second) queue.push_back(next);
  }
  return {};
}

// Finds a point with known winding number in the cell. Starts from the reference point of the
// loaded part of the mesh. Returns false if the cell does not overlap the box in which all faces
// are loaded.
bool LocalReferences::enter(Cell cell) const {
  const Eigen::AlignedBox3d common = around_.grid.box_of(cell).intersection(around_.held);
  if (common.isEmpty()) return false;
  const auto found = find_in(common, 0, around_.reference);
  if (found) known_.emplace(cell, *found);
  return found.has_value();
}

std::optional<ReferencePoint> LocalReferences::find_in(const Eigen::AlignedBox3d& box, int first,
                                                       const ReferencePoint& from) const {
  for (int i = 0; i < points_per_cell; ++i) {
    const Vec3 point = spread_point(box, first + i);
    if (const std::optional<int> sum = change(from.position, point))
      return ReferencePoint{point, from.winding + *sum};
  }
  return std::nullopt;
}

// Returns the change of the winding number from point `from` to point `to`, or nothing if the path
// touches an edge. The path consists of three segments parallel to the axes, because their bounding
// boxes meet few faces.
std::optional<int> LocalReferences::change(const Vec3& from, const Vec3& to) const {
  int sum = 0;
  Vec3 start = from;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 end = start;
    end[axis] = to[axis];
    AxisPath path(start, end);
    visit_faces_(start.cwiseMin(end), start.cwiseMax(end), [&](const Triangle& t) {
      path.add(t);
      return path.change().has_value();
    });
    if (!path.change()) return std::nullopt;
    sum += *path.change();
    start = end;
  }
  return sum;
}

}  // namespace transformesh

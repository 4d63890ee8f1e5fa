#include "clean/tiles/tile_boxes.h"

#include <algorithm>
#include <limits>
#include <span>

namespace transformesh {
namespace {

/// Number of grid cells along each axis. With half as many cells per axis, a cell touches several
/// boxes if there are 64 tiles. With twice as many, the grid does not fit into the cache.
constexpr int cells_per_side = 32;

void divide(std::span<Vec3> points, std::size_t count, const Box& box, std::vector<Box>& boxes) {
  if (count == 1) return boxes.push_back(box);
  Box around;
  for (const Vec3& point : points) around.extend(point);
  int axis = 0;
  if (!points.empty()) (around.max() / 2 - around.min() / 2).maxCoeff(&axis);
  const std::size_t first = count / 2;
  const std::size_t middle = points.size() * first / count;
  double split = box.min()[axis];
  auto end = points.begin();
  if (!points.empty()) {
    const auto is_before = [axis](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; };
    std::nth_element(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(middle),
                     points.end(), is_before);
    split = points[middle][axis];
    end = std::partition(points.begin(), points.end(),
                         [&](const Vec3& p) { return p[axis] < split; });
  }
  Box low = box, high = box;
  low.max()[axis] = high.min()[axis] = split;
  divide({points.begin(), end}, first, low, boxes);
  divide({end, points.end()}, count - first, high, boxes);
}

}  // namespace

std::vector<Box> divide_space(std::vector<Vec3> points, std::size_t count) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<Box> boxes;
  divide(points, count, {Vec3::Constant(-infinity), Vec3::Constant(infinity)}, boxes);
  return boxes;
}

BoxGrid::BoxGrid(const Box& bounds, std::vector<Box> boxes)
    : bounds_(bounds),
      boxes_(std::move(boxes)),
      cells_(std::size_t{cells_per_side} * cells_per_side * cells_per_side) {
  for (Index b = 0; b < boxes_.size(); ++b) {
    if (!(boxes_[b].min().array() <= boxes_[b].max().array()).all()) continue;
    const auto low = cell_of(boxes_[b].min()), high = cell_of(boxes_[b].max());
    for (int x = low[0]; x <= high[0]; ++x)
      for (int y = low[1]; y <= high[1]; ++y)
        for (int z = low[2]; z <= high[2]; ++z)
          cells_[static_cast<std::size_t>((x * cells_per_side + y) * cells_per_side + z)].push_back(
              b);
  }
}

std::array<int, 3> BoxGrid::cell_of(const Vec3& point) const {
  std::array<int, 3> cell{};
  for (int i = 0; i < 3; ++i) {
    const double low = bounds_.min()[i], high = bounds_.max()[i];
    const double share = (point[i] / 2 - low / 2) / (high / 2 - low / 2) * cells_per_side;
    cell[static_cast<std::size_t>(i)] = share >= cells_per_side - 1 ? cells_per_side - 1
                                        : share > 0                 ? static_cast<int>(share)
                                                                    : 0;
  }
  return cell;
}

void BoxGrid::find(const Vec3& low, const Vec3& high, std::vector<Index>& found) const {
  found.clear();
  const auto first = cell_of(low), last = cell_of(high);
  for (int x = first[0]; x <= last[0]; ++x)
    for (int y = first[1]; y <= last[1]; ++y)
      for (int z = first[2]; z <= last[2]; ++z) {
        const auto& cell =
            cells_[static_cast<std::size_t>((x * cells_per_side + y) * cells_per_side + z)];
        for (const Index b : cell)
          if ((boxes_[b].min().array() <= high.array()).all() &&
              (boxes_[b].max().array() >= low.array()).all())
            found.push_back(b);
      }
  if (first == last) return;
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
}

}  // namespace transformesh

#include "flow/sampled_grid.h"

#include <algorithm>
#include <cmath>

#include "support/number.h"

namespace transformesh {
namespace {

/// A point counts as outside of a grid if its distance from the grid exceeds this fraction of the
/// spacing of grid nodes. With 0, points on the boundary could count as outside because of
/// rounding.
constexpr double tolerance = 1e-6;

/// Position along an axis, between two neighboring grid nodes.
struct Place {
  std::size_t low = 0, high = 0;
  double weight = 0;  ///< weight of the node with the higher index, in [0, 1]
  bool is_outside = false;
};

Place place_on_axis(const FlowGrid& grid, Eigen::Index axis, double coordinate) {
  const std::size_t nodes = grid.size[static_cast<std::size_t>(axis)];
  if (nodes == 1) return {};
  const double last = static_cast<double>(nodes - 1);
  const double at = (coordinate - grid.origin[axis]) / grid.spacing[axis];
  const double clamped = std::clamp(at, 0.0, last);
  const double low = std::min(std::floor(clamped), last - 1);
  const auto index = static_cast<std::size_t>(low);
  return {index, index + 1, clamped - low, std::abs(at - clamped) > tolerance};
}

Vec3 node_value(const FlowGrid& grid, std::size_t x, std::size_t y, std::size_t z) {
  const std::size_t node = (z * grid.size[1] + y) * grid.size[0] + x;
  const double* values = grid.values.data() + node * grid.components;
  return grid.components == 3 ? Vec3(values[0], values[1], values[2]) : Vec3(values[0], 0, 0);
}

Vec3 mixed(const Vec3& a, const Vec3& b, double weight) { return (1 - weight) * a + weight * b; }

GridValue value_in(const FlowGrid& grid, const Vec3& point) {
  const Place x = place_on_axis(grid, 0, point.x()), y = place_on_axis(grid, 1, point.y()),
              z = place_on_axis(grid, 2, point.z());
  const auto row = [&](std::size_t j, std::size_t k) {
    return mixed(node_value(grid, x.low, j, k), node_value(grid, x.high, j, k), x.weight);
  };
  const auto layer = [&](std::size_t k) { return mixed(row(y.low, k), row(y.high, k), y.weight); };
  return {mixed(layer(z.low), layer(z.high), z.weight),
          x.is_outside || y.is_outside || z.is_outside};
}

void check(const FlowGrid& grid, std::size_t components) {
  constexpr std::size_t most_nodes = 1048576;  // per axis: the number of values fits into 64 bits
  if (std::ranges::max(grid.size) > most_nodes)
    throw UsageError("a grid has more than 1048576 nodes along an axis");
  const std::size_t nodes = grid.size[0] * grid.size[1] * grid.size[2];
  if (grid.components != components)
    throw UsageError("a grid has " + std::to_string(grid.components) +
                     " values per node, but must have " + std::to_string(components));
  if (nodes == 0 || grid.values.size() != nodes * components)
    throw UsageError("the number of values of a grid does not match its number of nodes");
  if (!grid.origin.allFinite() || !grid.spacing.allFinite() || !(grid.spacing.minCoeff() > 0))
    throw UsageError(
        "the origin and the spacing of a grid must be finite, and the spacing above 0");
}

}  // namespace

GridSeries::GridSeries(std::vector<FlowGrid> grids, std::size_t components)
    : grids_(std::move(grids)) {
  if (grids_.empty()) throw UsageError("the flow has no grid: name its files");
  for (const FlowGrid& grid : grids_) {
    check(grid, components);
    if (!grid.time && grids_.size() > 1)
      throw InputError("one of " + std::to_string(grids_.size()) +
                       " grids does not state its time: give the time between consecutive grids");
  }
  std::ranges::stable_sort(grids_, {}, [](const FlowGrid& grid) { return grid.time.value_or(0); });
  for (std::size_t i = 1; i < grids_.size(); ++i)
    if (*grids_[i].time == *grids_[i - 1].time)
      throw InputError("two grids have the time " + shortest_text(*grids_[i].time));
}

GridSeries::Interval GridSeries::around(double time) const {
  if (grids_.size() == 1) return {&grids_[0], &grids_[0], 0, false};
  const auto after =
      std::ranges::upper_bound(grids_, time, {}, [](const FlowGrid& grid) { return *grid.time; });
  if (after == grids_.begin()) return {&*after, &*after, 0, true};
  const FlowGrid& before = *(after - 1);
  if (after == grids_.end()) return {&before, &before, 0, time > *before.time};
  return {&before, &*after, (time - *before.time) / (*after->time - *before.time), false};
}

GridValue value_at(const GridSeries::Interval& interval, const Vec3& point) {
  const GridValue first = value_in(*interval.first, point);
  if (interval.weight == 0) return first;
  const GridValue second = value_in(*interval.second, point);
  return {mixed(first.value, second.value, interval.weight), first.is_outside || second.is_outside};
}

}  // namespace transformesh

/// Values between the nodes of grids: trilinear in space, linear in time.
#pragma once

#include <vector>

#include "transformesh/flow.h"

namespace transformesh {

/// Grids of one quantity at one or more times.
class GridSeries {
 public:
  /// Sorts the grids by time. Throws UsageError if there is none, or if the numbers of values,
  /// nodes and components do not agree. Throws InputError if one of several grids has no time, or
  /// if two have the same.
  GridSeries(std::vector<FlowGrid> grids, std::size_t components);

  /// Two grids and the weight of the second one.
  struct Interval {
    const FlowGrid* first = nullptr;
    const FlowGrid* second = nullptr;
    double weight = 0;
    bool is_outside = false;  ///< the time is before the first grid or after the last one
  };
  /// Returns the grids before and after a time; the nearest grid twice if the time is outside.
  Interval around(double time) const;

 private:
  std::vector<FlowGrid> grids_;
};

/// The value of a grid at a point. If the grid has one component, only value.x() is used.
struct GridValue {
  Vec3 value = Vec3::Zero();
  bool is_outside = false;  ///< the point was clamped to the box of the nodes
};

GridValue value_at(const GridSeries::Interval& interval, const Vec3& point);

}  // namespace transformesh

/// Interpolates values between the nodes of grids: trilinear in space, linear in time.
#pragma once

#include <vector>

#include "transformesh/flow.h"

namespace transformesh {

/// Grids of one quantity, such as velocity, at one or more points in time.
class GridSeries {
 public:
  /// Sorts the grids by time. Throws UsageError if there is no grid, or if the numbers of values,
  /// nodes and components do not agree. Throws InputError if one of several grids has no time, or
  /// if two grids have the same time.
  GridSeries(std::vector<FlowGrid> grids, std::size_t components);

  /// Two grids with consecutive times, and the weight of the second one.
  struct Interval {
    const FlowGrid* first = nullptr;
    const FlowGrid* second = nullptr;
    double weight = 0;
    bool is_outside = false;  ///< true if the time is before the first grid or after the last one
  };
  /// Returns the last grid before a time and the first grid after it. If the time is outside of the
  /// series, returns the nearest grid twice.
  Interval around(double time) const;

 private:
  std::vector<FlowGrid> grids_;
};

/// The value of a grid at a point. If the grid has one component, only value.x() is used.
struct GridValue {
  Vec3 value = Vec3::Zero();
  /// True if the point was outside and was clamped to the box of the grid nodes.
  bool is_outside = false;
};

GridValue value_at(const GridSeries::Interval& interval, const Vec3& point);

}  // namespace transformesh

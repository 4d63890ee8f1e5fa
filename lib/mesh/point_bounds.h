/// Bounds of many points, found by several threads.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "support/parallel.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct PointBounds {
  Vec3 low, high;
};

/// Returns the bounds of point_of(0) to point_of(count - 1); `count` must not be 0. The result,
/// including the signs of zeros, does not depend on the number of threads. NaN coordinates are
/// skipped.
template <class PointOf>
PointBounds bounds_of_points(std::size_t count, const PointOf& point_of) {
  constexpr std::size_t block = 8192;  // affects time only
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<PointBounds> bounds((count + block - 1) / block);
  parallel_for(bounds.size(), 1, [&](std::size_t from, std::size_t to) {
    for (std::size_t b = from; b < to; ++b) {
      // Separate variables, because the compiler keeps them in registers.
      double x0 = infinity, y0 = infinity, z0 = infinity;
      double x1 = -infinity, y1 = -infinity, z1 = -infinity;
      for (std::size_t i = b * block; i < std::min(count, (b + 1) * block); ++i) {
        const auto& point = point_of(i);
        x0 = std::min(x0, point[0]), y0 = std::min(y0, point[1]), z0 = std::min(z0, point[2]);
        x1 = std::max(x1, point[0]), y1 = std::max(y1, point[1]), z1 = std::max(z1, point[2]);
      }
      bounds[b] = {Vec3(x0, y0, z0), Vec3(x1, y1, z1)};
    }
  });
  PointBounds all = bounds[0];
  for (const PointBounds& of_block : bounds) {
    all.low = all.low.cwiseMin(of_block.low);
    all.high = all.high.cwiseMax(of_block.high);
  }
  return all;
}

}  // namespace transformesh

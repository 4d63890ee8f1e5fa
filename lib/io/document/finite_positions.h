/// Test whether all positions of a mesh are finite.
#pragma once

#include <atomic>

#include "support/parallel.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// True if all coordinates are finite numbers. Parallel.
inline bool are_finite(const std::vector<Vec3>& positions) {
  constexpr std::size_t per_task = 16384;  // affects time only
  std::atomic<bool> are_all_finite = true;
  parallel_for(positions.size(), per_task, [&](std::size_t first, std::size_t last) {
    bool are_here = true;
    for (std::size_t i = first; i < last; ++i) are_here &= positions[i].allFinite();
    if (!are_here) are_all_finite = false;
  });
  return are_all_finite;
}

}  // namespace transformesh

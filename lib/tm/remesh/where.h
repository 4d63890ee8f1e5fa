/// Looks over all slots of a mesh that is edited, on all threads.
#pragma once

#include <algorithm>
#include <vector>

#include "tm/remesh/editable_mesh.h"
#include "tm/support/parallel.h"

namespace transformesh {

/// The indices below `count` for which is_wanted(index) holds, ascending. It is called from several
/// threads at once.
template <class IsWanted>
std::vector<Index> indices_where(Index count, const IsWanted& is_wanted) {
  constexpr std::size_t per_part = 8192;
  std::vector<std::vector<Index>> parts((count + per_part - 1) / per_part);
  parallel_for(parts.size(), 1, [&](std::size_t from, std::size_t to) {
    for (std::size_t part = from; part < to; ++part) {
      const std::size_t last = std::min<std::size_t>(count, (part + 1) * per_part);
      for (std::size_t i = part * per_part; i < last; ++i) {
        if (is_wanted(static_cast<Index>(i))) parts[part].push_back(static_cast<Index>(i));
      }
    }
  });
  std::vector<Index> result;
  for (const std::vector<Index>& part : parts)
    result.insert(result.end(), part.begin(), part.end());
  return result;
}

}  // namespace transformesh

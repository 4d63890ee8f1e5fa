/// Loops on all allowed threads. Results must not depend on the number of threads: write to slots
/// indexed by the loop variable, and reduce in index order afterwards.
#pragma once

#include <cstddef>
#include <functional>

#include "transformesh/control.h"

namespace transformesh {

/// Calls body(first, last) on disjoint ranges that cover [0, count); all but the last hold at least
/// `grain` indices. Of the exceptions that bodies throw, that of the lowest range reaches the
/// caller, and ranges not yet begun are left out.
void parallel_for(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t first, std::size_t last)>& body);

/// Runs both, perhaps at the same time.
void parallel_invoke(const std::function<void()>& first, const std::function<void()>& second);

}  // namespace transformesh

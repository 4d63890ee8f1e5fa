/// Parallel loops on the allowed threads. The innermost ThreadLimit (control.h) sets their number;
/// without a limit, there is one per core. Results must not depend on the number of threads: write
/// to slots indexed by the loop variable, and reduce in index order afterwards. The ranges depend
/// on the number of threads, so do not add up floating-point numbers per range.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "transformesh/control.h"

namespace transformesh {

/// Calls body(first, last) on disjoint ranges that cover [0, count). All ranges except the last
/// have at least `grain` indices. If bodies throw, the exception of the lowest range is rethrown,
/// and ranges that have not started are skipped.
void parallel_for(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t first, std::size_t last)>& body);

/// Calls body(index) for each index below `count`, in parallel. `count` must fit into 32 bits.
/// Threads take at least 4096 indices at a time, which is efficient if a call takes nanoseconds.
template <class Body>
void parallel_for_each(std::size_t count, const Body& body) {
  constexpr std::size_t grain = 4096;  // affects time only
  parallel_for(count, grain, [&](std::size_t first, std::size_t last) {
    for (auto i = static_cast<std::uint32_t>(first); i < last; ++i) body(i);
  });
}

/// Runs both functions, concurrently if a thread is available. Rethrows exceptions as
/// parallel_for() does.
void parallel_invoke(const std::function<void()>& first, const std::function<void()>& second);

}  // namespace transformesh

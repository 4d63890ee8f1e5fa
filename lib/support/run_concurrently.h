/// Runs two functions concurrently on the threads of parallel.h.
#pragma once

#include <functional>

namespace transformesh {

/// Runs `own` in this thread, and `other` concurrently, or afterwards if no thread is available. An
/// exception of `own` is rethrown after `other` has ended; `other` is skipped if it has not
/// started. `other` must not throw.
void run_concurrently(const std::function<void()>& own, const std::function<void()>& other);

}  // namespace transformesh

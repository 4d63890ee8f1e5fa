/// Runs two functions concurrently on the threads of parallel.h.
#pragma once

#include <functional>

namespace transformesh {

/// Runs `own` in this thread and `other` beside it, or afterwards where no thread is free. What
/// `own` throws reaches the caller, once `other` has ended; `other` must not throw.
void run_concurrently(const std::function<void()>& own, const std::function<void()>& other);

}  // namespace transformesh

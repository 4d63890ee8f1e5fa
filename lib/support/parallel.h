/// Loops on all allowed threads. Results must not depend on the number of threads: write to slots
/// indexed by the loop variable, and reduce in index order afterwards.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace transformesh {

/// Calls body(first, last) on disjoint ranges that cover [0, count); all but the last hold at least
/// `grain` indices. Of the exceptions that bodies throw, that of the lowest range reaches the
/// caller, and ranges not yet begun are left out.
void parallel_for(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t first, std::size_t last)>& body);

/// Runs both, perhaps at the same time.
void parallel_invoke(const std::function<void()>& first, const std::function<void()>& second);

/// How many threads loops may use now: for work that is done in groups, to save memory.
std::size_t allowed_thread_count();

/// While alive, the library uses at most `count` threads, which may be more than there are cores; 0
/// changes nothing, and without any limit there is one per core. The innermost limit counts.
class ThreadLimit {
 public:
  explicit ThreadLimit(int count);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct Control;
  std::unique_ptr<Control> control_;
};

}  // namespace transformesh

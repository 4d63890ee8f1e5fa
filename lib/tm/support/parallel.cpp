#include "tm/support/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>

namespace transformesh {

void parallel_for(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  if (count <= grain) return body(0, count);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, std::max<std::size_t>(grain, 1)),
                    [&](const auto& range) { body(range.begin(), range.end()); });
}

void parallel_invoke(const std::function<void()>& first, const std::function<void()>& second) {
  tbb::parallel_invoke(first, second);
}

struct ThreadLimit::Control {
  // Made in place: a copy would lift the limit when it goes.
  explicit Control(std::size_t count)
      : threads(tbb::global_control::max_allowed_parallelism, count) {}
  tbb::global_control threads;
};

ThreadLimit::ThreadLimit(int count) {
  if (count <= 0) return;
  control_ = std::make_unique<Control>(static_cast<std::size_t>(count));
}

ThreadLimit::~ThreadLimit() = default;

}  // namespace transformesh

#include "support/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "support/run_concurrently.h"
#include "transformesh/control.h"

namespace transformesh {
namespace {

/// Number of ranges for each thread. A choice: with more ranges, loops whose iterations take
/// different times are balanced better; with fewer ranges, the overhead is less.
constexpr std::size_t ranges_per_thread = 16;

std::size_t cores() { return std::max(1U, std::thread::hardware_concurrency()); }

/// `allowed_threads` may work at the same time. `working_threads` do: the first caller and its
/// helpers.
std::atomic<std::size_t> allowed_threads{cores()};
std::atomic<std::size_t> working_threads{1};

bool take_thread() {
  std::size_t working = working_threads;
  while (working < allowed_threads) {
    if (working_threads.compare_exchange_weak(working, working + 1)) return true;
  }
  return false;
}

void give_thread_back() { --working_threads; }

/// The ranges of one loop. Threads take them in order.
class Loop {
 public:
  Loop(std::size_t count, std::size_t range,
       const std::function<void(std::size_t, std::size_t)>& body)
      : count_(count), range_(range), body_(body) {}

  /// Processes ranges until none is left.
  void work() {
    for (;;) {
      const std::size_t first = next_.fetch_add(range_);
      if (first >= count_) return;
      try {
        body_(first, std::min(count_, first + range_));
      } catch (...) {
        next_ = count_;
        keep_error(first);
      }
    }
  }

  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  // Keeps the error of the lowest range. All lower ranges have been taken already, so the result
  // does not depend on the timing of threads.
  void keep_error(std::size_t first) {
    const std::lock_guard lock(mutex_);
    if (error_ && first > error_at_) return;
    error_ = std::current_exception();
    error_at_ = first;
  }

  std::size_t count_;
  std::size_t range_;
  const std::function<void(std::size_t, std::size_t)>& body_;
  std::atomic<std::size_t> next_{0};
  std::mutex mutex_;
  std::exception_ptr error_;
  std::size_t error_at_ = 0;
};

/// Joins helper threads. The waiting thread does not count as working, so that nested loops of the
/// helpers may use another thread instead.
template <class Threads>
void wait_for(Threads& threads) {
  give_thread_back();
  threads = Threads();
  ++working_threads;
}

/// Works on the loop with up to `wanted` more threads, if they are allowed and the system can
/// create them. A nested loop uses threads that other loops no longer need, so no loop waits for a
/// thread. Starting a thread takes about 10 us, which is less than a thread that spins between two
/// loops would take.
void work_together(Loop& loop, std::size_t wanted) {
  std::vector<std::jthread> helpers;
  helpers.reserve(wanted);
  while (helpers.size() < wanted && take_thread()) {
    try {
      helpers.emplace_back([&loop] {
        loop.work();
        give_thread_back();
      });
    } catch (const std::system_error&) {
      give_thread_back();
      break;
    }
  }
  loop.work();
  if (!helpers.empty()) wait_for(helpers);
}

}  // namespace

void parallel_for(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  const std::size_t threads = allowed_threads;
  if (count <= grain || threads == 1) return body(0, count);
  const std::size_t range =
      std::max({std::size_t{1}, grain, count / (ranges_per_thread * threads)});
  Loop loop(count, range, body);
  work_together(loop, std::min(threads, (count + range - 1) / range) - 1);
  loop.rethrow();
}

void run_concurrently(const std::function<void()>& own, const std::function<void()>& other) {
  std::jthread helper;
  if (take_thread()) {
    try {
      helper = std::jthread([&other] {
        other();
        give_thread_back();
      });
    } catch (const std::system_error&) {
      give_thread_back();
    }
  }
  try {
    own();
  } catch (...) {
    if (helper.joinable()) wait_for(helper);
    throw;
  }
  if (helper.joinable()) {
    wait_for(helper);
  } else {
    other();
  }
}

std::size_t allowed_thread_count() { return allowed_threads; }

void parallel_invoke(const std::function<void()>& first, const std::function<void()>& second) {
  parallel_for(2, 1, [&](std::size_t from, std::size_t to) {
    if (from == 0) first();
    if (to == 2) second();
  });
}

struct ThreadLimit::Control {
  explicit Control(std::size_t count) : before(allowed_threads) { allowed_threads = count; }
  ~Control() { allowed_threads = before; }
  Control(const Control&) = delete;
  Control& operator=(const Control&) = delete;
  std::size_t before;
};

ThreadLimit::ThreadLimit(int count) {
  if (count <= 0) return;
  control_ = std::make_unique<Control>(static_cast<std::size_t>(count));
}

ThreadLimit::~ThreadLimit() = default;

}  // namespace transformesh

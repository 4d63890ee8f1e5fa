#include "support/parallel.h"

#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
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

/// `allowed_threads` is the number of threads that may work at the same time. `working_threads` is
/// the number of threads that do: the first caller and its helpers.
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

  std::size_t helpers = 0;  ///< workers that process ranges; guarded by the mutex of the workers
  std::condition_variable has_no_helpers;

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

/// Threads that wait for loops. Programs run hundreds of short loops; waking a thread takes less
/// than starting one. A loop does not wait for workers that have not begun when its last range is
/// taken, which matters on a machine that is busy. Workers are never joined: they end with the
/// process.
class Workers {
 public:
  static Workers& instance() {
    static Workers& workers = *new Workers;
    return workers;
  }

  /// Offers the loop to `count` workers.
  void offer(Loop& loop, std::size_t count) {
    const std::lock_guard lock(mutex_);
    forget_parent_process();
    offers_.insert(offers_.end(), count, &loop);
    while (idle_ < offers_.size() && start()) {
    }
    for (std::size_t i = 0; i < count; ++i) has_offers_.notify_one();
  }

  /// Withdraws the offers that no worker has taken, and waits for the others. The waiting thread
  /// does not count as working, so that nested loops of the helpers may use another thread instead.
  void finish(Loop& loop) {
    std::unique_lock lock(mutex_);
    for (std::size_t left = std::erase(offers_, &loop); left > 0; --left) give_thread_back();
    if (loop.helpers == 0) return;
    give_thread_back();
    loop.has_no_helpers.wait(lock, [&] { return loop.helpers == 0; });
    ++working_threads;
  }

 private:
  // Starts a worker, which counts as idle at once. Returns false if the system refuses.
  bool start() {
    try {
      std::thread([this] { run(); }).detach();
    } catch (const std::system_error&) {
      return false;
    }
    ++idle_;
    return true;
  }

  void run() {
    std::unique_lock lock(mutex_);
    for (;;) {
      has_offers_.wait(lock, [&] { return !offers_.empty(); });
      Loop& loop = *offers_.back();
      offers_.pop_back();
      --idle_;
      ++loop.helpers;
      lock.unlock();
      loop.work();
      lock.lock();
      give_thread_back();
      ++idle_;
      if (--loop.helpers == 0) loop.has_no_helpers.notify_one();
    }
  }

  // Workers do not exist in a process that was forked.
  void forget_parent_process() {
    if (process_ == getpid()) return;
    process_ = getpid();
    idle_ = 0;
    offers_.clear();
  }

  std::mutex mutex_;
  std::condition_variable has_offers_;
  std::vector<Loop*> offers_;  ///< a loop for each worker that may join it
  std::size_t idle_ = 0;       ///< workers that wait for offers, or start
  pid_t process_ = getpid();
};

/// Works on the loop with up to `wanted` more threads, if they are allowed and the system can
/// create them. A nested loop uses threads that other loops no longer need, so no loop waits for a
/// thread.
void work_together(Loop& loop, std::size_t wanted) {
  std::size_t helpers = 0;
  while (helpers < wanted && take_thread()) ++helpers;
  if (helpers == 0) return loop.work();
  Workers::instance().offer(loop, helpers);
  loop.work();
  Workers::instance().finish(loop);
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

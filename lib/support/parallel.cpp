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
#include <utility>
#include <vector>

#include "support/run_concurrently.h"
#include "transformesh/control.h"

namespace transformesh {
namespace {

/// A thread takes the next 1 / (ranges_per_thread * threads) of the remaining indices. Ranges thus
/// become smaller towards the end of a loop, so that threads end at nearly the same time. Chosen by
/// hand. A larger value balances loops with iterations of different cost better; a smaller value
/// has less overhead.
constexpr std::size_t ranges_per_thread = 16;

std::size_t cores() { return std::max(1U, std::thread::hardware_concurrency()); }

std::atomic<std::size_t> allowed_threads{cores()};  ///< threads that may work at the same time

/// One parallel loop. Its indices are divided into ranges, which threads take in ascending order.
class Loop {
 public:
  Loop(std::size_t count, std::size_t grain, std::size_t threads,
       const std::function<void(std::size_t, std::size_t)>& body)
      : count_(count), grain_(grain), shares_(ranges_per_thread * threads), body_(body) {}

  /// Processes ranges until none is left.
  void work() {
    for (;;) {
      const auto [first, last] = take_range();
      if (first >= count_) return;
      try {
        body_(first, last);
      } catch (...) {
        next_ = count_;
        keep_error(first);
      }
    }
  }

  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

  // The next three members are guarded by Workers::mutex_.
  std::size_t helpers = 0;  ///< number of workers that process ranges of this loop
  bool caller_waits = false;
  std::condition_variable has_no_helpers;

 private:
  std::pair<std::size_t, std::size_t> take_range() {
    std::size_t first = next_, last = 0;
    do {
      if (first >= count_) return {count_, count_};
      last = std::min(count_, first + std::max(grain_, (count_ - first) / shares_));
    } while (!next_.compare_exchange_weak(first, last));
    return {first, last};
  }

  // If several ranges throw, stores the error of the lowest one. All lower ranges have been taken
  // already, so the result does not depend on the timing of threads.
  void keep_error(std::size_t first) {
    const std::lock_guard lock(mutex_);
    if (error_ && first > error_at_) return;
    error_ = std::current_exception();
    error_at_ = first;
  }

  std::size_t count_;
  std::size_t grain_;
  std::size_t shares_;
  const std::function<void(std::size_t, std::size_t)>& body_;
  std::atomic<std::size_t> next_{0};
  std::mutex mutex_;
  std::exception_ptr error_;
  std::size_t error_at_ = 0;
};

/// Pool of worker threads, which are reused because waking a thread is faster than starting one,
/// and programs run hundreds of short loops. A worker may join a loop at any time before the loop
/// ends, if fewer threads work than are allowed. A loop that has no ranges left does not wait for
/// workers that have not joined it, which matters on a busy machine. Workers run until the process
/// ends.
class Workers {
 public:
  static Workers& instance() {
    static Workers& workers = *new Workers;
    return workers;
  }

  /// Offers the loop to at most `count` workers.
  void offer(Loop& loop, std::size_t count) {
    const std::lock_guard lock(mutex_);
    forget_parent_process();
    offers_.insert(offers_.end(), count, &loop);
    wake();
  }

  /// Withdraws the offers of this loop that no worker has taken. Then waits for the workers that
  /// have joined the loop. The waiting thread does not count as working, so that a worker may join
  /// another loop instead.
  void finish(Loop& loop) {
    std::unique_lock lock(mutex_);
    std::erase(offers_, &loop);
    if (loop.helpers == 0) return;
    loop.caller_waits = true;
    --working_;
    wake();
    loop.has_no_helpers.wait(lock, [&] { return loop.helpers == 0; });
  }

  /// Reserves one more working thread. Returns false if the allowed number of threads already
  /// works.
  bool take_thread() {
    const std::lock_guard lock(mutex_);
    forget_parent_process();
    if (working_ >= allowed_threads) return false;
    ++working_;
    return true;
  }
  void give_thread_back() {
    const std::lock_guard lock(mutex_);
    --working_;
    wake();
  }
  /// Waits for the end of a thread for which take_thread() returned true. The waiting thread does
  /// not count as working.
  void join(std::jthread& thread) {
    give_thread_back();
    thread.join();
    const std::lock_guard lock(mutex_);
    ++working_;
  }

 private:
  bool may_join() const { return !offers_.empty() && working_ < allowed_threads; }

  // Wakes idle workers, and starts new ones if necessary: as many as offers and the limit of
  // working threads permit.
  void wake() {
    if (!may_join()) return;
    const std::size_t count = std::min(offers_.size(), allowed_threads - working_);
    while (idle_ < count && start()) {
    }
    for (std::size_t i = 0; i < count; ++i) has_offers_.notify_one();
  }

  // Starts a worker and counts it as idle immediately. Returns false if the system cannot start a
  // thread.
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
      has_offers_.wait(lock, [&] { return may_join(); });
      Loop& loop = *offers_.back();
      offers_.pop_back();
      --idle_;
      ++working_;
      ++loop.helpers;
      lock.unlock();
      loop.work();
      lock.lock();
      ++idle_;
      // If this was the last helper and the loop's caller waits, the caller continues in place of
      // this worker. `working_` then stays the same.
      if (--loop.helpers == 0 && loop.caller_waits)
        loop.has_no_helpers.notify_one();
      else
        --working_;
    }
  }

  // fork() does not copy worker threads to the child process, so the child starts without workers.
  void forget_parent_process() {
    if (process_ == getpid()) return;
    process_ = getpid();
    idle_ = 0;
    working_ = 1;
    offers_.clear();
  }

  std::mutex mutex_;
  std::condition_variable has_offers_;
  /// Offered loops; a loop is listed once for each worker that may still join it.
  std::vector<Loop*> offers_;
  std::size_t idle_ = 0;     ///< number of workers that wait for offers or are being started
  std::size_t working_ = 1;  ///< number of working threads, including the thread that called first
  pid_t process_ = getpid();
};

}  // namespace

void parallel_for(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  const std::size_t threads = allowed_threads;
  if (count <= grain || threads == 1) return body(0, count);
  grain = std::max(grain, std::size_t{1});
  Loop loop(count, grain, threads, body);
  Workers& workers = Workers::instance();
  workers.offer(loop, std::min(threads, (count + grain - 1) / grain) - 1);
  loop.work();
  workers.finish(loop);
  loop.rethrow();
}

void run_concurrently(const std::function<void()>& own, const std::function<void()>& other) {
  Workers& workers = Workers::instance();
  std::jthread helper;
  if (workers.take_thread()) {
    try {
      helper = std::jthread([&] {
        other();
        workers.give_thread_back();
      });
    } catch (const std::system_error&) {
      workers.give_thread_back();
    }
  }
  try {
    own();
  } catch (...) {
    if (helper.joinable()) workers.join(helper);
    throw;
  }
  if (helper.joinable()) {
    workers.join(helper);
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

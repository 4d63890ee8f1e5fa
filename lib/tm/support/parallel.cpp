#include "tm/support/parallel.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace transformesh {
namespace {

/// Ranges per thread: enough to even out bodies of unequal cost.
constexpr std::size_t ranges_per_thread = 16;

std::size_t cores() { return std::max(1U, std::thread::hardware_concurrency()); }

/// How many threads may work at once, the caller among them.
std::atomic<std::size_t> allowed_threads{cores()};

/// The ranges of one loop, handed out in order to whoever comes.
class Loop {
 public:
  Loop(std::size_t count, std::size_t range,
       const std::function<void(std::size_t, std::size_t)>& body)
      : count_(count), range_(range), body_(body) {}

  /// Until no range is left.
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
  // The first one in order, so that it does not depend on the threads: all ranges before it have
  // been handed out.
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

/// Threads that help with loops, and sleep while there are none. They start when first needed and
/// live as long as the process. A loop inside a loop is helped likewise; its caller waits for
/// helpers only while they work, never for one that has not come, so nothing can lock up.
class Helpers {
 public:
  /// Never destroyed: a thread may be asleep in it when the process ends.
  static Helpers& all() {
    static auto* const helpers = new Helpers;
    return *helpers;
  }

  void run(Loop& loop, std::size_t wanted) {
    Call call{&loop, wanted, 0};
    {
      const std::lock_guard lock(mutex_);
      calls_.push_back(&call);
      start_threads(wanted);
    }
    for (std::size_t i = 0; i < wanted; ++i) is_wanted_.notify_one();
    loop.work();

    std::unique_lock lock(mutex_);
    calls_.erase(std::find(calls_.begin(), calls_.end(), &call));
    has_left_.wait(lock, [&] { return call.helping == 0; });
  }

 private:
  struct Call {
    Loop* loop;
    std::size_t wanted;
    std::size_t helping;
  };

  /// So that `wanted` are idle, if so many are allowed and the system gives them.
  void start_threads(std::size_t wanted) {
    try {
      for (; threads_ - busy_ < wanted && threads_ + 1 < allowed_threads; ++threads_) {
        std::thread([this] { serve(); }).detach();
      }
    } catch (const std::system_error&) {
      // Then with fewer.
    }
  }

  [[noreturn]] void serve() {
    std::unique_lock lock(mutex_);
    for (;;) {
      Call* call = nullptr;
      is_wanted_.wait(lock, [&] { return (call = next_call()) != nullptr; });
      --call->wanted;
      ++call->helping;
      ++busy_;
      lock.unlock();
      call->loop->work();
      lock.lock();
      --busy_;
      if (--call->helping == 0) has_left_.notify_all();
    }
  }

  /// The innermost loop that wants help, while more threads are allowed to work.
  Call* next_call() const {
    if (busy_ + 1 >= allowed_threads) return nullptr;
    const auto found = std::find_if(calls_.rbegin(), calls_.rend(),
                                    [](const Call* call) { return call->wanted > 0; });
    return found == calls_.rend() ? nullptr : *found;
  }

  std::mutex mutex_;
  std::condition_variable is_wanted_;
  std::condition_variable has_left_;
  std::vector<Call*> calls_;
  std::size_t threads_ = 0;
  std::size_t busy_ = 0;
};

}  // namespace

void parallel_for(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  const std::size_t threads = allowed_threads;
  if (count <= grain || threads == 1) return body(0, count);
  const std::size_t range =
      std::max({std::size_t{1}, grain, count / (ranges_per_thread * threads)});
  Loop loop(count, range, body);
  Helpers::all().run(loop, std::min(threads, (count + range - 1) / range) - 1);
  loop.rethrow();
}

void parallel_invoke(const std::function<void()>& first, const std::function<void()>& second) {
  parallel_for(2, 1, [&](std::size_t from, std::size_t to) {
    if (from == 0) first();
    if (to == 2) second();
  });
}

struct ThreadLimit::Control {
  explicit Control(std::size_t count) : before(allowed_threads) {
    allowed_threads = std::min(before, count);
  }
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

/// Controls long operations: their progress, their cancellation, and the number of threads.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string_view>

#include "transformesh/errors.h"

namespace transformesh {

/// Reports the progress of an operation. An operation calls its Progress with fraction 0 at the
/// start of each phase, then at least every few milliseconds of work with a growing fraction. If
/// the callback returns false, the operation throws CancelledError and leaves its arguments valid
/// but unspecified. The callback is called from one thread at a time.
class Progress {
 public:
  using Callback = std::function<bool(std::string_view phase, double fraction)>;

  Progress() = default;
  explicit Progress(Callback callback) : callback_(std::move(callback)) {}

  void operator()(std::string_view phase, double fraction = 0) const {
    if (callback_ && !callback_(phase, fraction)) throw CancelledError("cancelled");
  }

 private:
  Callback callback_;
};

/// Returns the number of threads that operations may use now.
std::size_t allowed_thread_count();

/// Limits operations to `count` threads while this object exists; 0 changes nothing. `count` may be
/// larger than the number of cores. Without any limit there is one thread per core. The innermost
/// of nested limits counts. Results do not depend on the number of threads.
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

/// Progress of a long operation, and the way to stop it. An operation calls its Progress at the
/// start of each phase with fraction 0 and then, at least every few milliseconds of work, with a
/// growing fraction. A callback that returns false cancels: the operation throws CancelledError and
/// leaves its arguments valid but unspecified. Called from one thread at a time.
#pragma once

#include <functional>
#include <string_view>

#include "support/error.h"

namespace transformesh {

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

}  // namespace transformesh

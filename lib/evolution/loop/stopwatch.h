/// Stopwatch: measures wall-clock time, in seconds, since its construction or the last call of
/// lap().
#pragma once

#include <chrono>

namespace transformesh {

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }
  double lap() {
    const double passed = seconds();
    begin_ = std::chrono::steady_clock::now();
    return passed;
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace transformesh

/// How long each phase of a run took.
#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace transformesh::tool {

class Phases {
 public:
  /// Ends the phase that runs and begins this one; time of equal names adds up. An empty name only
  /// ends.
  void begin(std::string_view name);

  /// Seconds by name, in order of first appearance. Names have underscores for spaces.
  const std::vector<std::pair<std::string, double>>& seconds() const { return seconds_; }
  /// Since this object was made.
  double total_seconds() const;

 private:
  using Clock = std::chrono::steady_clock;
  void add(const std::string& name, double seconds);

  Clock::time_point started_ = Clock::now();
  Clock::time_point phase_started_ = started_;
  std::string current_;
  std::vector<std::pair<std::string, double>> seconds_;
};

/// The largest amount of memory that this process has held so far, in bytes.
long peak_memory_bytes();

}  // namespace transformesh::tool

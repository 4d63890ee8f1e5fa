#include "phases.h"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>

namespace transformesh::tool {

void Phases::begin(std::string_view name) {
  if (name == current_ && !name.empty()) return;
  const auto now = Clock::now();
  if (!current_.empty()) {
    std::string key = current_;
    std::replace(key.begin(), key.end(), ' ', '_');
    add(key, std::chrono::duration<double>(now - phase_started_).count());
  }
  current_ = name;
  phase_started_ = now;
}

void Phases::add(const std::string& name, double seconds) {
  for (auto& [known, sum] : seconds_) {
    if (known != name) continue;
    sum += seconds;
    return;
  }
  seconds_.emplace_back(name, seconds);
}

double Phases::total_seconds() const {
  return std::chrono::duration<double>(Clock::now() - started_).count();
}

long peak_memory_bytes() {
  // getrusage would also count what the process held before it became this program.
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    long kibibytes = 0;
    if (word == "VmHWM:" && status >> kibibytes) return kibibytes * 1024;
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss * 1024;
}

}  // namespace transformesh::tool

/// Functions that all fuzz targets share: how a finding ends the process, and how an input is read
/// as a sequence of choices. Targets are for libFuzzer (llvm.org/docs/LibFuzzer.html); scripts/fuzz
/// runs them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "io/streams/source.h"

namespace transformesh::fuzz {

/// The function of each target; every exception that it throws is a finding.
void run_target(std::string_view bytes);

/// Description of the input, which is shown with a finding; empty if a target does not set it.
inline std::string input_text;

/// Reports a finding and aborts, so that libFuzzer keeps the input.
[[noreturn]] inline void fail(const std::string& what) {
  std::fprintf(stderr, "finding: %s\n%s", what.c_str(), input_text.c_str());
  std::abort();
}

inline void demand(bool holds, const std::string& what) {
  if (!holds) fail(what);
}

inline void demand_same(const std::string& first, const std::string& second,
                        const std::string& what) {
  if (first == second) return;
  const auto places = std::mismatch(first.begin(), first.end(), second.begin(), second.end());
  const auto start = static_cast<std::size_t>(places.first - first.begin());
  fail(what + ": " + in_quotes(std::string_view(first).substr(start)) + " and then " +
       in_quotes(std::string_view(second).substr(start)) + " at byte " + std::to_string(start));
}

/// Reads bytes as choices; returns zero if none is left.
class Choices {
 public:
  explicit Choices(std::string_view bytes) : rest_(bytes) {}

  std::uint8_t byte() {
    if (rest_.empty()) return 0;
    const auto taken = static_cast<std::uint8_t>(rest_.front());
    rest_.remove_prefix(1);
    return taken;
  }
  /// Returns a number below `count`, which must be at most 256.
  unsigned below(unsigned count) { return byte() % count; }
  bool flag() { return below(2) == 1; }
  bool is_empty() const { return rest_.empty(); }
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
};

}  // namespace transformesh::fuzz

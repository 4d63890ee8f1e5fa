/// What all fuzz targets share: how a finding ends the process, and an input read as a row of
/// choices. Targets are for libFuzzer (llvm.org/docs/LibFuzzer.html); scripts/fuzz runs them.
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

/// Every target defines it; whatever it throws is a finding.
void run_target(std::string_view bytes);

/// Shown with a finding: the input in words, where a target has them.
inline std::string input_text;

/// libFuzzer then keeps the input.
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
  fail(what + ": " + quoted(std::string_view(first).substr(start)) + " and then " +
       quoted(std::string_view(second).substr(start)) + " at byte " + std::to_string(start));
}

/// Bytes as choices; zero where none is left.
class Choices {
 public:
  explicit Choices(std::string_view bytes) : rest_(bytes) {}

  std::uint8_t byte() {
    if (rest_.empty()) return 0;
    const auto taken = static_cast<std::uint8_t>(rest_.front());
    rest_.remove_prefix(1);
    return taken;
  }
  /// At most 256 of them.
  unsigned below(unsigned count) { return byte() % count; }
  bool flag() { return below(2) == 1; }
  bool is_empty() const { return rest_.empty(); }
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
};

}  // namespace transformesh::fuzz

/// Pseudorandom numbers that are the same on every machine (SplitMix64). Reference: Steele,
/// Lea & Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014.
#pragma once

#include <cstdint>

namespace transformesh {

/// A bijection of 64-bit words in which every input bit affects all output bits.
constexpr std::uint64_t mixed(std::uint64_t word) {
  word = (word ^ (word >> 30)) * 0xbf58476d1ce4e5b9U;
  word = (word ^ (word >> 27)) * 0x94d049bb133111ebU;
  return word ^ (word >> 31);
}

class Random {
 public:
  explicit constexpr Random(std::uint64_t seed) : state_(mixed(seed)) {}

  constexpr std::uint64_t word() { return mixed(state_ += 0x9e3779b97f4a7c15U); }
  /// Returns a number in [low, high).
  constexpr double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(word() >> 11) * 0x1p-53);
  }
  /// Returns an integer in [low, high]. The distribution is uniform if the range is small compared
  /// with 2^64.
  constexpr long integer(long low, long high) {
    return low + static_cast<long>(word() % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::uint64_t state_;
};

}  // namespace transformesh

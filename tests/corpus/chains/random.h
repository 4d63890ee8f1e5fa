/// Random numbers that are the same on every machine: splitmix64.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace chains {

class Random {
 public:
  /// Neighboring seeds give unrelated sequences.
  explicit Random(std::uint64_t seed) : state_(mixed(seed + 0x632be59bd9b4e019U)) {}

  std::uint64_t bits() { return mixed(state_ += 0x9e3779b97f4a7c15U); }
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(bits() >> 11U) * 0x1p-53;
  }
  /// Returns an integer from `low` to `high`, both included.
  int integer(int low, int high) {
    return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool chance(double probability) { return uniform(0, 1) < probability; }
  template <typename Container>
  const auto& pick(const Container& choices) {
    return choices[bits() % choices.size()];
  }

 private:
  static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }
  std::uint64_t state_;
};

}  // namespace chains

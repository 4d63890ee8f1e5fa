/// Computes the minimum of numbers that several threads find concurrently. The result does not
/// depend on the timing of the threads.
#pragma once

#include <atomic>

namespace transformesh {

/// Lowers the shared number to `value` if it is larger. `Shared` is std::atomic or std::atomic_ref.
template <class Shared, class Number>
void lower_to(Shared&& shared, Number value) {
  Number known = shared.load(std::memory_order_relaxed);
  while (value < known && !shared.compare_exchange_weak(known, value, std::memory_order_relaxed)) {
  }
}

}  // namespace transformesh

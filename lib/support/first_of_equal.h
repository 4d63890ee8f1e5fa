/// Finds the first of equal items by a hash table with open addressing, whose slots hold item
/// numbers.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

class FirstOfEqual {
 public:
  /// `count` is the largest number of different items.
  explicit FirstOfEqual(std::size_t count = 0) : slots_(std::bit_ceil(2 * count + 1), no_index) {}

  /// Returns the number of the first item that is equal to `item`. Inserts `item` if there is none.
  template <class IsEqual>
  Index find_or_insert(std::uint64_t hash, Index item, const IsEqual& is_equal) {
    Index& found = slots_[slot_of(hash, is_equal)];
    if (found == no_index) found = item;
    return found;
  }

  /// Returns the number of the item for which is_equal() is true, or no_index.
  template <class IsEqual>
  Index find(std::uint64_t hash, const IsEqual& is_equal) const {
    return slots_[slot_of(hash, is_equal)];
  }

 private:
  template <class IsEqual>
  std::size_t slot_of(std::uint64_t hash, const IsEqual& is_equal) const {
    std::size_t slot = (hash >> 20) & (slots_.size() - 1);
    while (slots_[slot] != no_index && !is_equal(slots_[slot]))
      slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }

  std::vector<Index> slots_;
};

}  // namespace transformesh

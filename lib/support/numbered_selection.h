/// Selects indices of a range by a predicate, and numbers the selected indices consecutively in
/// ascending order. Works in parallel: threads count the selected indices in blocks, and a prefix
/// sum over the blocks yields the first number in each block. The numbers therefore do not depend
/// on the number of threads.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "support/parallel.h"
#include "support/raw_vector.h"

namespace transformesh {

class NumberedSelection {
 public:
  /// Selects the indices below `count` for which is_selected(index) is true. The function is called
  /// once for each index, from several threads.
  template <class IsSelected>
  NumberedSelection(std::size_t count, const IsSelected& is_selected)
      : marks_((count + word - 1) / word), first_number_((marks_.size() + block - 1) / block + 1) {
    for_each_block([&](std::size_t b, std::size_t first, std::size_t last) {
      std::size_t selected = 0;
      for (std::size_t w = first; w < last; ++w) {
        const std::size_t begin = w * word, size = std::min(word, count - begin);
        std::uint64_t marks = 0;
        for (std::size_t k = 0; k < size; ++k)
          marks |= std::uint64_t{is_selected(begin + k) ? 1U : 0U} << k;
        marks_[w] = marks;
        selected += static_cast<std::size_t>(std::popcount(marks));
      }
      first_number_[b + 1] = selected;
    });
    for (std::size_t b = 1; b < first_number_.size(); ++b) first_number_[b] += first_number_[b - 1];
  }

  /// Returns the number of selected indices.
  std::size_t size() const { return first_number_.back(); }

  /// Calls visit(index, number) for each selected index, from several threads.
  template <class Visit>
  void visit(const Visit& visit) const {
    for_each_block([&](std::size_t b, std::size_t first, std::size_t last) {
      std::size_t number = first_number_[b];
      for (std::size_t w = first; w < last; ++w)
        for (std::uint64_t marks = marks_[w]; marks != 0; marks &= marks - 1)
          visit(w * word + static_cast<std::size_t>(std::countr_zero(marks)), number++);
    });
  }

  /// Returns the selected indices.
  RawVector<std::uint32_t> list() const {
    RawVector<std::uint32_t> indices(size());
    visit([&](std::size_t i, std::size_t n) { indices[n] = static_cast<std::uint32_t>(i); });
    return indices;
  }

 private:
  static constexpr std::size_t word = 64;    ///< bits per word
  static constexpr std::size_t block = 128;  ///< words per block; affects time only

  template <class Body>
  void for_each_block(const Body& body) const {
    parallel_for(first_number_.size() - 1, 1, [&](std::size_t from, std::size_t to) {
      for (std::size_t b = from; b < to; ++b)
        body(b, b * block, std::min(marks_.size(), (b + 1) * block));
    });
  }

  RawVector<std::uint64_t> marks_;  ///< one bit per index of the range: 1 if the index is selected
  /// Prefix sums over blocks: number of selected indices before each block.
  std::vector<std::size_t> first_number_;
};

}  // namespace transformesh

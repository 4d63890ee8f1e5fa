/// Functions for lists of index pairs with attached data: concatenation and sorting.
#pragma once

#include <algorithm>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

template <class Entry>
std::vector<Entry> joined(const std::vector<std::vector<Entry>>& lists) {
  std::size_t count = 0;
  for (const auto& list : lists) count += list.size();
  std::vector<Entry> result;
  result.reserve(count);
  for (const auto& list : lists) result.insert(result.end(), list.begin(), list.end());
  return result;
}

/// Sorts entries by `first`, then by `second`. All first entries must be less than `bound`. O(n +
/// bound) if few entries have the same `first`.
template <class Entry>
void sort_pairs(std::vector<Entry>& pairs, std::size_t bound) {
  const auto comes_before = [](const Entry& a, const Entry& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  };
  if (pairs.size() < bound / 4) return std::sort(pairs.begin(), pairs.end(), comes_before);

  // If there are many pairs, sort them by the first entry in a counting sort. It leaves few
  // comparisons.
  std::vector<std::size_t> slot(bound + 1, 0);
  for (const Entry& pair : pairs) ++slot[pair.first + 1];
  for (std::size_t i = 1; i < slot.size(); ++i) slot[i] += slot[i - 1];
  std::vector<Entry> sorted(pairs.size());
  for (const Entry& pair : pairs) sorted[slot[pair.first]++] = pair;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < bound; ++i) {
    const std::size_t end = slot[i];
    std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(begin),
              sorted.begin() + static_cast<std::ptrdiff_t>(end), comes_before);
    begin = end;
  }
  pairs.swap(sorted);
}

}  // namespace transformesh

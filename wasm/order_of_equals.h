/// std::nth_element with the steps of libstdc++ 12. The standard leaves the order of equal elements
/// open, and two results depend on it: the trees of lib/geometry/search/median_tree and the
/// insertion order of CGAL's triangulations (Hilbert_sort_median_2). Sorting and heaps need nothing
/// alike, because the order of their elements is total or does not matter. An overload with a
/// constraint is preferred to that of libc++. Reference: Musser, "Introspective sorting and
/// selection algorithms", Software: Practice and Experience, 1997.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace transformesh::order {

/// Ranges up to this length are left to insertion sort, as in libstdc++.
constexpr std::ptrdiff_t threshold = 3;

template <class It, class Less>
void insertion_sort(It first, It last, Less& less) {
  for (It i = first; i != last; ++i) {
    auto value = std::move(*i);
    It hole = i;
    for (; hole != first && less(value, *(hole - 1)); --hole) *hole = std::move(*(hole - 1));
    *hole = std::move(value);
  }
}

/// Returns the one of three places whose element is the median.
template <class It, class Less>
It median(It a, It b, It c, Less& less) {
  if (less(*a, *b)) return less(*b, *c) ? b : less(*a, *c) ? c : a;
  return less(*a, *c) ? a : less(*b, *c) ? c : b;
}

/// Partitions by the median of three elements, which comes first. Returns where the upper part
/// begins.
template <class It, class Less>
It partition_by_median(It first, It last, Less& less) {
  std::iter_swap(first, median(first + 1, first + (last - first) / 2, last - 1, less));
  It low = first + 1, high = last;
  while (true) {
    while (less(*low, *first)) ++low;
    --high;
    while (less(*first, *high)) --high;
    if (!(low < high)) return low;
    std::iter_swap(low, high);
    ++low;
  }
}

/// Twice the binary logarithm, as in libstdc++: the number of partitions after which a hostile
/// order of the input is assumed. The library sorts the rest then, and may order equal elements
/// otherwise.
inline int depth_limit(std::ptrdiff_t count) {
  int bits = 0;
  for (; count > 1; count /= 2) ++bits;
  return 2 * bits;
}

template <class It, class Less>
void select(It first, It nth, It last, Less& less) {
  if (first == last || nth == last) return;
  for (int depth = depth_limit(last - first); last - first > threshold; --depth) {
    if (depth == 0) return std::partial_sort(first, nth + 1, last, less);
    const It cut = partition_by_median(first, last, less);
    if (cut <= nth)
      first = cut;
    else
      last = cut;
  }
  insertion_sort(first, last, less);
}

}  // namespace transformesh::order

#ifdef _LIBCPP_VERSION
// NOLINTBEGIN(cert-dcl58-cpp): a function of the standard library itself is replaced
_LIBCPP_BEGIN_NAMESPACE_STD

template <class It, class Less>
requires random_access_iterator<It>
void nth_element(It first, It nth, It last, Less less) {
  transformesh::order::select(first, nth, last, less);
}

_LIBCPP_END_NAMESPACE_STD
// NOLINTEND(cert-dcl58-cpp)
#endif

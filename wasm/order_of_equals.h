/// Sorting, selection and heaps with the steps of libstdc++ 12. The standard leaves the order of
/// equal elements open, and results may depend on it: of two equally near faces the first one found
/// is taken. Overloads with a constraint are preferred to those of libc++. Included before the
/// headers that call these functions, such as <queue>. References: Musser, "Introspective sorting
/// and selection algorithms", Software: Practice and Experience, 1997; Knuth, "The art of computer
/// programming", volume 3, 5.2.3 (heapsort that sifts a hole to the bottom first).
#pragma once

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

namespace transformesh::order {

/// Ranges up to this length are left to insertion sort, as in libstdc++.
constexpr std::ptrdiff_t threshold = 16;

template <class It, class Less>
void push(It first, std::ptrdiff_t hole, std::ptrdiff_t top, auto value, Less& less) {
  for (; hole > top && less(first[(hole - 1) / 2], value); hole = (hole - 1) / 2)
    first[hole] = std::move(first[(hole - 1) / 2]);
  first[hole] = std::move(value);
}

/// Sifts the hole to a leaf along the larger children, and lets the value rise from there.
template <class It, class Less>
void adjust(It first, std::ptrdiff_t hole, std::ptrdiff_t length, auto value, Less& less) {
  const std::ptrdiff_t top = hole;
  while (hole < (length - 1) / 2) {
    std::ptrdiff_t child = 2 * (hole + 1);
    if (less(first[child], first[child - 1])) --child;
    first[hole] = std::move(first[child]);
    hole = child;
  }
  if (length % 2 == 0 && hole == (length - 2) / 2) {
    first[hole] = std::move(first[2 * hole + 1]);
    hole = 2 * hole + 1;
  }
  push(first, hole, top, std::move(value), less);
}

template <class It, class Less>
void make(It first, It last, Less& less) {
  for (std::ptrdiff_t parent = (last - first - 2) / 2; last - first > 1 && parent >= 0; --parent) {
    auto value = std::move(first[parent]);
    adjust(first, parent, last - first, std::move(value), less);
  }
}

/// Moves the top to `result`, whose value enters the heap [first, last).
template <class It, class Less>
void pop(It first, It last, It result, Less& less) {
  auto value = std::move(*result);
  *result = std::move(*first);
  adjust(first, 0, last - first, std::move(value), less);
}

template <class It, class Less>
void sort_of_heap(It first, It last, Less& less) {
  for (; last - first > 1; --last) pop(first, last - 1, last - 1, less);
}

/// Brings the smallest elements before `middle`, as a heap.
template <class It, class Less>
void select_by_heap(It first, It middle, It last, Less& less) {
  make(first, middle, less);
  for (It i = middle; i < last; ++i)
    if (less(*i, *first)) pop(first, middle, i, less);
}

template <class It, class Less>
void insert_unguarded(It last, Less& less) {
  auto value = std::move(*last);
  for (It before = last - 1; less(value, *before); --before) {
    *last = std::move(*before);
    last = before;
  }
  *last = std::move(value);
}

template <class It, class Less>
void insertion_sort(It first, It last, Less& less) {
  if (first == last) return;
  for (It i = first + 1; i != last; ++i) {
    if (!less(*i, *first)) {
      insert_unguarded(i, less);
      continue;
    }
    auto value = std::move(*i);
    std::move_backward(first, i, i + 1);
    *first = std::move(value);
  }
}

/// Partitions by the median of three elements, which comes first. Returns where the upper part
/// begins.
template <class It, class Less>
It partition_by_median(It first, It last, Less& less) {
  const It a = first + 1, b = first + (last - first) / 2, c = last - 1;
  const It median = less(*a, *b) ? (less(*b, *c)   ? b
                                    : less(*a, *c) ? c
                                                   : a)
                                 : (less(*a, *c)   ? a
                                    : less(*b, *c) ? c
                                                   : b);
  std::iter_swap(first, median);
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

inline int depth_limit(std::ptrdiff_t count) {
  int bits = 0;
  for (; count > 1; count /= 2) ++bits;
  return 2 * bits;
}

template <class It, class Less>
void introsort(It first, It last, int depth, Less& less) {
  while (last - first > threshold) {
    if (depth-- == 0) {
      select_by_heap(first, last, last, less);
      return sort_of_heap(first, last, less);
    }
    const It cut = partition_by_median(first, last, less);
    introsort(cut, last, depth, less);
    last = cut;
  }
}

template <class It, class Less>
void sort(It first, It last, Less& less) {
  if (first == last) return;
  introsort(first, last, depth_limit(last - first), less);
  const It end = last - first > threshold ? first + threshold : last;
  insertion_sort(first, end, less);
  for (It i = end; i != last; ++i) insert_unguarded(i, less);
}

template <class It, class Less>
void select(It first, It nth, It last, Less& less) {
  if (first == last || nth == last) return;
  for (int depth = depth_limit(last - first); last - first > 3; --depth) {
    if (depth == 0) {
      select_by_heap(first, nth + 1, last, less);
      return std::iter_swap(first, nth);
    }
    const It cut = partition_by_median(first, last, less);
    if (cut <= nth)
      first = cut;
    else
      last = cut;
  }
  insertion_sort(first, last, less);
}

}  // namespace transformesh::order

// NOLINTBEGIN(cert-dcl58-cpp): the functions of the standard library themselves are replaced
_LIBCPP_BEGIN_NAMESPACE_STD

template <class It>
concept has_order_of_equals = random_access_iterator<It>;

template <has_order_of_equals It, class Less>
void sort(It first, It last, Less less) {
  transformesh::order::sort(first, last, less);
}
template <has_order_of_equals It>
void sort(It first, It last) {
  std::less<> less;
  transformesh::order::sort(first, last, less);
}
template <has_order_of_equals It, class Less>
void nth_element(It first, It nth, It last, Less less) {
  transformesh::order::select(first, nth, last, less);
}
template <has_order_of_equals It>
void nth_element(It first, It nth, It last) {
  std::less<> less;
  transformesh::order::select(first, nth, last, less);
}
template <has_order_of_equals It, class Less>
void partial_sort(It first, It middle, It last, Less less) {
  transformesh::order::select_by_heap(first, middle, last, less);
  transformesh::order::sort_of_heap(first, middle, less);
}
template <has_order_of_equals It>
void partial_sort(It first, It middle, It last) {
  std::less<> less;
  transformesh::order::select_by_heap(first, middle, last, less);
  transformesh::order::sort_of_heap(first, middle, less);
}
template <has_order_of_equals It, class Less>
void push_heap(It first, It last, Less less) {
  auto value = std::move(*(last - 1));
  transformesh::order::push(first, last - first - 1, 0, std::move(value), less);
}
template <has_order_of_equals It>
void push_heap(It first, It last) {
  push_heap(first, last, std::less<>());
}
template <has_order_of_equals It, class Less>
void pop_heap(It first, It last, Less less) {
  if (last - first > 1) transformesh::order::pop(first, last - 1, last - 1, less);
}
template <has_order_of_equals It>
void pop_heap(It first, It last) {
  pop_heap(first, last, std::less<>());
}
template <has_order_of_equals It, class Less>
void make_heap(It first, It last, Less less) {
  transformesh::order::make(first, last, less);
}
template <has_order_of_equals It>
void make_heap(It first, It last) {
  make_heap(first, last, std::less<>());
}

_LIBCPP_END_NAMESPACE_STD
// NOLINTEND(cert-dcl58-cpp)

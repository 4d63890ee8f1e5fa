/// Adds the parts of C++20 that the sources use and that some versions of libc++ lack. It is
/// included before every source of the WebAssembly build (libc++ 13) and of native builds with
/// libc++.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <compare>
#include <cstring>
#include <functional>
#include <iterator>
#include <thread>
#include <type_traits>
#include <utility>

#include "order_of_equals.h"

namespace std {

#if _LIBCPP_VERSION < 14000
template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  static_assert(sizeof(To) == sizeof(From));
  return __builtin_bit_cast(To, from);
}

/// Writes the shorter notation, or the fixed one of equally short ones, as libstdc++ does.
to_chars_result to_chars(char* first, char* last, double value);
to_chars_result to_chars(char* first, char* last, float value);
to_chars_result to_chars(char* first, char* last, double value, chars_format, int precision);
#endif

#if _LIBCPP_VERSION < 17000
template <class T, size_t size>
constexpr auto operator<=>(const array<T, size>& a, const array<T, size>& b) {
  for (size_t i = 0; i < size; ++i)
    if (const auto order = a[i] <=> b[i]; order != 0) return order;
  return decltype(a[0] <=> b[0])::equal;
}
#endif

#ifndef __cpp_lib_atomic_ref
/// Every access is sequentially consistent, whatever the order that is asked for.
template <class T>
struct atomic_ref {
  explicit atomic_ref(T& number) : number_(&number) {}
  void store(T value, memory_order = memory_order_seq_cst) const {
    __atomic_store_n(number_, value, __ATOMIC_SEQ_CST);
  }
  T load(memory_order = memory_order_seq_cst) const {
    return __atomic_load_n(number_, __ATOMIC_SEQ_CST);
  }
  T fetch_and(T value, memory_order = memory_order_seq_cst) const {
    return __atomic_fetch_and(number_, value, __ATOMIC_SEQ_CST);
  }
  bool compare_exchange_strong(T& expected, T desired, memory_order = memory_order_seq_cst) const {
    return __atomic_compare_exchange_n(number_, &expected, desired, false, __ATOMIC_SEQ_CST,
                                       __ATOMIC_SEQ_CST);
  }
  bool compare_exchange_weak(T& expected, T desired, memory_order = memory_order_seq_cst) const {
    return compare_exchange_strong(expected, desired);
  }

 private:
  T* number_;
};
#endif

#ifndef __cpp_lib_jthread
struct jthread : thread {
  using thread::thread;
  jthread() = default;
  jthread(jthread&&) = default;
  jthread& operator=(jthread&& other) {
    if (joinable()) join();
    thread::operator=(std::move(other));
    return *this;
  }
  ~jthread() {
    if (joinable()) join();
  }
};

#endif

#if _LIBCPP_VERSION < 200000
from_chars_result from_chars(const char* first, const char* last, double& value);
from_chars_result from_chars(const char* first, const char* last, float& value);
#endif

#if _LIBCPP_VERSION < 15000
namespace ranges {

struct as_it_is {
  template <class T>
  constexpr T&& operator()(T&& value) const {
    return static_cast<T&&>(value);
  }
};

template <class Compare, class Projection>
auto projected(Compare& compare, Projection& projection) {
  return [&](const auto& a, const auto& b) {
    return invoke(compare, invoke(projection, a), invoke(projection, b));
  };
}

template <class Range, class Compare = std::less<void>, class Projection = as_it_is>
void sort(Range&& range, Compare compare = {}, Projection projection = {}) {
  std::sort(std::begin(range), std::end(range), projected(compare, projection));
}
template <class Range, class Compare = std::less<void>, class Projection = as_it_is>
void stable_sort(Range&& range, Compare compare = {}, Projection projection = {}) {
  std::stable_sort(std::begin(range), std::end(range), projected(compare, projection));
}
template <class Range, class Test>
auto find_if(Range&& range, Test test) {
  return std::find_if(std::begin(range), std::end(range), test);
}
template <class Range, class T, class Projection = as_it_is>
auto find(Range&& range, const T& value, Projection projection = {}) {
  return std::find_if(std::begin(range), std::end(range),
                      [&](const auto& element) { return invoke(projection, element) == value; });
}
template <class Range, class Test>
auto adjacent_find(Range&& range, Test test) {
  return std::adjacent_find(std::begin(range), std::end(range), test);
}
template <class Range, class T>
auto count(Range&& range, const T& value) {
  return std::count(std::begin(range), std::end(range), value);
}
template <class Range, class Test>
auto count_if(Range&& range, Test test) {
  return std::count_if(std::begin(range), std::end(range), test);
}
template <class Range, class Test>
bool all_of(Range&& range, Test test) {
  return std::all_of(std::begin(range), std::end(range), test);
}
template <class Range, class Test>
bool any_of(Range&& range, Test test) {
  return std::any_of(std::begin(range), std::end(range), test);
}
template <class Range, class Test>
bool none_of(Range&& range, Test test) {
  return std::none_of(std::begin(range), std::end(range), test);
}
template <class Range, class T, class Compare = std::less<void>, class Projection = as_it_is>
auto lower_bound(Range&& range, const T& value, Compare compare = {}, Projection projection = {}) {
  return std::lower_bound(
      std::begin(range), std::end(range), value,
      [&](const auto& a, const T& b) { return invoke(compare, invoke(projection, a), b); });
}
template <class Range, class T, class Compare = std::less<void>, class Projection = as_it_is>
auto upper_bound(Range&& range, const T& value, Compare compare = {}, Projection projection = {}) {
  return std::upper_bound(
      std::begin(range), std::end(range), value,
      [&](const T& a, const auto& b) { return invoke(compare, a, invoke(projection, b)); });
}
template <class Range, class T, class Compare = std::less<void>, class Projection = as_it_is>
bool binary_search(Range&& range, const T& value, Compare compare = {},
                   Projection projection = {}) {
  const auto found = ranges::lower_bound(range, value, compare, projection);
  return found != std::end(range) && !invoke(compare, value, invoke(projection, *found));
}
template <class Range>
auto min_element(Range&& range) {
  return std::min_element(std::begin(range), std::end(range));
}
template <class Range>
auto max_element(Range&& range) {
  return std::max_element(std::begin(range), std::end(range));
}
template <class Range>
auto min(Range&& range) {
  return *std::min_element(std::begin(range), std::end(range));
}
template <class Range>
auto max(Range&& range) {
  return *std::max_element(std::begin(range), std::end(range));
}
template <class Range, class Out, class Function>
void transform(Range&& range, Out out, Function function) {
  std::transform(std::begin(range), std::end(range), out, function);
}
template <class Range, class Test, class T>
void replace_if(Range&& range, Test test, const T& value) {
  std::replace_if(std::begin(range), std::end(range), test, value);
}
template <class Range, class Other, class Out>
void set_difference(Range&& range, Other&& other, Out out) {
  std::set_difference(std::begin(range), std::end(range), std::begin(other), std::end(other), out);
}
template <class Range, class Other>
bool equal(Range&& range, Other&& other) {
  return std::equal(std::begin(range), std::end(range), std::begin(other), std::end(other));
}
template <class Range, class Other>
bool lexicographical_compare(Range&& range, Other&& other) {
  return std::lexicographical_compare(std::begin(range), std::end(range), std::begin(other),
                                      std::end(other));
}

}  // namespace ranges
#endif
}  // namespace std

/// Connected components of a graph on 0 .. n - 1, found by several threads. The smallest element
/// represents its component, so that the result does not depend on the threads.
///
/// Reference: Jayadharini Jaiganesh, Martin Burtscher, "A High-Performance Connected Components
/// Implementation for GPUs", 2018. Each element first points to its smallest neighbor. Only the
/// edges to other neighbors need an atomic compare and swap.
#pragma once

#include <atomic>
#include <cstddef>
#include <utility>

#include "support/numbered_selection.h"
#include "support/parallel.h"
#include "support/raw_vector.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Union-find without locks. Parents are smaller than their children, so there are no cycles.
class SharedSets {
 public:
  explicit SharedSets(std::size_t size) : parent_(size) {}

  /// Sets the first parent of an element; must be called once for each element before find().
  void set_parent(Index element, Index parent) { parent_[element] = parent; }

  Index find(Index element) {
    Index parent = at(element).load(std::memory_order_relaxed);
    while (parent != element) {
      const Index above = at(parent).load(std::memory_order_relaxed);
      if (above != parent) at(element).store(above, std::memory_order_relaxed);
      element = parent;
      parent = above;
    }
    return element;
  }

  void join(Index first, Index second) {
    first = find(first);
    second = find(second);
    while (first != second) {
      if (second < first) std::swap(first, second);
      Index expected = second;
      if (at(second).compare_exchange_strong(expected, first, std::memory_order_relaxed)) return;
      second = find(expected);
      first = find(first);
    }
  }

 private:
  std::atomic_ref<Index> at(Index element) { return std::atomic_ref(parent_[element]); }

  RawVector<Index> parent_;
};

/// Returns for each element the smallest element that is connected with it. neighbors(element,
/// visit) calls visit(neighbor) for each neighbor; an element must be a neighbor of its neighbors.
/// Close to O(n).
template <class Neighbors>
RawVector<Index> connected_minima(std::size_t size, const Neighbors& neighbors) {
  const auto least_neighbor = [&](Index i) {
    Index least = i;
    neighbors(i, [&](Index neighbor) { least = neighbor < least ? neighbor : least; });
    return least;
  };
  SharedSets sets(size);
  parallel_for_each(size, [&](Index i) { sets.set_parent(i, least_neighbor(i)); });
  parallel_for_each(size, [&](Index i) {
    const Index least = least_neighbor(i);
    neighbors(i, [&](Index neighbor) {
      if (neighbor < i && neighbor != least) sets.join(i, neighbor);
    });
  });
  RawVector<Index> minima(size);
  parallel_for_each(size, [&](Index i) { minima[i] = sets.find(i); });
  return minima;
}

/// Numbers the components in ascending order of their smallest elements. On entry, `minima[i]` is
/// the smallest element of the component of i; on return, it is the number of this component. A
/// component is left out if is_included() is false for its elements; their entry is then no_index.
/// Returns the smallest element of each component.
template <class IsIncluded>
RawVector<Index> number_components(RawVector<Index>& minima, const IsIncluded& is_included) {
  const NumberedSelection selection(minima.size(), [&](std::size_t i) {
    return minima[i] == i && is_included(static_cast<Index>(i));
  });
  RawVector<Index> smallest(selection.size());
  RawVector<Index> number_of(minima.size());
  selection.visit([&](std::size_t i, std::size_t number) {
    smallest[number] = static_cast<Index>(i);
    number_of[i] = static_cast<Index>(number);
  });
  parallel_for_each(minima.size(),
                    [&](Index i) { minima[i] = is_included(i) ? number_of[minima[i]] : no_index; });
  return smallest;
}

}  // namespace transformesh

/// Union-find on 0 .. n - 1. The smallest element represents its set, so that the result does not
/// depend on the order of the joins.
#pragma once

#include <numeric>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  Index find(Index element) {
    while (parent_[element] != element) {
      parent_[element] = parent_[parent_[element]];
      element = parent_[element];
    }
    return element;
  }

  /// Joins the sets of two elements. Returns false if both were already in one set.
  bool join(Index first, Index second) {
    first = find(first);
    second = find(second);
    if (first == second) return false;
    if (second < first) std::swap(first, second);
    parent_[second] = first;
    return true;
  }

 private:
  std::vector<Index> parent_;
};

}  // namespace transformesh

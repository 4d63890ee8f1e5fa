/// Edges of a set of oriented faces, with the number of times that faces traverse them. The edges
/// with a number other than 0 are the boundary of the set.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// An edge of one or more faces. Its count is the number of faces that traverse it from `low` to
/// `high`, minus the number that traverse it in the other direction.
struct CountedEdge {
  Index low, high;
  int count;
  auto key() const { return std::pair(low, high); }
  bool operator<(const CountedEdge& other) const { return key() < other.key(); }
};

using CountedEdges = std::vector<CountedEdge>;

/// Appends the three edges of a face, each counted once.
inline void append_edges(const Face& face, CountedEdges& edges) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Index from = face[k], to = face[(k + 1) % 3];
    edges.push_back({std::min(from, to), std::max(from, to), from < to ? 1 : -1});
  }
}

/// Adds up equal edges of a sorted list and removes those with count 0.
inline void add_up(CountedEdges& edges) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < edges.size();) {
    CountedEdge sum = edges[i];
    while (++i < edges.size() && edges[i].key() == sum.key()) sum.count += edges[i].count;
    if (sum.count != 0) edges[kept++] = sum;
  }
  edges.resize(kept);
}

}  // namespace transformesh

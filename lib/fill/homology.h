/// Which loops of edges separate a surface: only where no handle holds the two sides together.
/// Every halfedge gets a word, the same as its opposite; a loop separates its component where the
/// words along it cancel (exclusive or), but for a chance of 2^-64. Most words are 0. Words of
/// loops that are independent of each other may be cut along together.
/// Trees of vertices and of faces whose edges do not cross leave two edges for each handle, and the
/// loops of faces through these are counted (Eppstein, Dynamic generators of topologically embedded
/// graphs, SODA 2003). Cost: O(n), and for each handle the depth of a tree. Deterministic.
#pragma once

#include <cstdint>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

using HomologyWord = std::uint64_t;

/// Of every halfedge. Pre: a closed oriented manifold, and its opposites.
std::vector<HomologyWord> homology_words(const Mesh& mesh, const std::vector<Index>& opposites);

/// The words of loops that a surface was cut along.
class IndependentWords {
 public:
  /// Whether no sum of those added is this word.
  bool is_new(HomologyWord word) const { return remainder(word) != 0; }
  void add(HomologyWord word);

 private:
  HomologyWord remainder(HomologyWord word) const;

  std::vector<HomologyWord> reduced_;  ///< descending; the leading bits differ
};

}  // namespace transformesh

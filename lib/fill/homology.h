/// Decides which loops of edges separate a closed surface. Every halfedge gets a 64-bit word, equal
/// to the word of its opposite. A loop separates its component if the exclusive or of the words of
/// its halfedges is 0, with an error probability of 2^-64. Most words are 0. The surface stays
/// connected if it is cut along several loops whose words are linearly independent over GF(2).
///
/// A spanning tree of vertices and a spanning tree of faces that do not cross leave two edges per
/// handle. Each of these edges defines a loop of faces, whose words are accumulated. Reference:
/// Eppstein, "Dynamic generators of topologically embedded graphs", SODA 2003. Cost: O(n), plus the
/// depth of a tree for each handle. Deterministic.
#pragma once

#include <cstdint>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

using HomologyWord = std::uint64_t;

/// Returns the word of every halfedge. Pre: a closed oriented manifold with its opposite halfedges.
std::vector<HomologyWord> homology_words(const Mesh& mesh, const std::vector<Index>& opposites);

/// The words of loops along which a surface was cut.
class IndependentWords {
 public:
  /// True if no exclusive or of the added words equals this word.
  bool is_new(HomologyWord word) const { return remainder(word) != 0; }
  void add(HomologyWord word);

 private:
  HomologyWord remainder(HomologyWord word) const;

  /// Basis of the added words: descending, with distinct leading bits.
  std::vector<HomologyWord> reduced_;
};

}  // namespace transformesh

/// Decides which loops of edges separate a closed surface. Every halfedge gets a 64-bit number, its
/// word; opposite halfedges have equal words. A loop separates its component into two parts if the
/// exclusive or of the words of its halfedges is 0. The probability of a wrong decision is 2^-64.
/// Most words are 0. The word of a loop is the exclusive or of the words of its halfedges. A
/// component that is cut along several disjoint loops stays connected if the words of the loops are
/// linearly independent over GF(2).
///
/// Take a spanning tree of the vertices, and a spanning tree of the faces that crosses no edge of
/// the vertex tree. Two edges per handle are in neither tree. Each of these edges closes a loop of
/// faces in the face tree. It gets a random word, which is added to the words of all edges that
/// this loop crosses. Reference: Eppstein, "Dynamic generators of topologically embedded graphs",
/// SODA 2003. Cost: O(n), plus the depth of a tree for each handle. Deterministic.
#pragma once

#include <cstdint>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

using HomologyWord = std::uint64_t;

/// Returns the word of every halfedge. Precondition: `mesh` is a closed oriented manifold with the
/// opposite halfedges `opposites`.
std::vector<HomologyWord> homology_words(const Mesh& mesh, const std::vector<Index>& opposites);

/// Stores the words of loops along which a surface was cut, and tests whether a further loop is
/// independent of them.
class IndependentWords {
 public:
  /// True if the word is linearly independent of the added words: it is not 0, and no exclusive or
  /// of added words equals it.
  bool is_new(HomologyWord word) const { return remainder(word) != 0; }
  void add(HomologyWord word);

 private:
  HomologyWord remainder(HomologyWord word) const;

  /// Basis of the linear space of the added words over GF(2): descending, with distinct leading
  /// bits.
  std::vector<HomologyWord> reduced_;
};

}  // namespace transformesh

#include "fill/homology.h"

#include <algorithm>
#include <functional>

namespace transformesh {
namespace {

/// Returns the pseudorandom number with index `number` of a sequence (SplitMix64: Steele, Lea &
/// Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014).
HomologyWord scattered(HomologyWord number) {
  number = (number + 1) * 0x9e3779b97f4a7c15ULL;
  number = (number ^ (number >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  number = (number ^ (number >> 27U)) * 0x94d049bb133111ebULL;
  return number ^ (number >> 31U);
}

class Trees {
 public:
  Trees(const Mesh& mesh, const std::vector<Index>& opposites)
      : mesh_(mesh), opposites_(opposites), is_taken_(opposites.size(), 0) {
    grow_over_vertices();
    grow_over_faces();
  }

  std::vector<HomologyWord> words() const;

 private:
  void grow_over_vertices();
  void grow_over_faces();
  void take(Index halfedge) { is_taken_[halfedge] = is_taken_[opposites_[halfedge]] = 1; }
  void add_loop(Index halfedge, HomologyWord word, std::vector<HomologyWord>& words) const;

  const Mesh& mesh_;
  const std::vector<Index>& opposites_;
  /// 1 for each halfedge whose edge is in the spanning tree of vertices, or is crossed by the
  /// spanning tree of faces.
  std::vector<char> is_taken_;
  /// Halfedge of each face across which its parent in the face tree is; no_index for a root.
  std::vector<Index> up_;
  std::vector<Index> depth_;  ///< depth of each face in the face tree
};

// Grows the spanning tree of vertices by breadth-first search. Its paths are short, which leads to
// fewer halfedges with nonzero words.
void Trees::grow_over_vertices() {
  std::vector<char> is_reached(mesh_.positions.size(), 0);
  for (Index root = 0; root < opposites_.size(); ++root) {
    if (is_reached[halfedge_source(mesh_, root)]) continue;
    is_reached[halfedge_source(mesh_, root)] = 1;
    std::vector<Index> queue{root};  // an outgoing halfedge of each reached vertex
    for (std::size_t i = 0; i < queue.size(); ++i) {
      Index h = queue[i];
      do {
        char& is_old = is_reached[halfedge_target(mesh_, h)];
        if (!is_old) {
          is_old = 1;
          take(h);
          queue.push_back(opposites_[h]);
        }
        h = opposites_[previous_halfedge(h)];
      } while (h != queue[i]);
    }
  }
}

void Trees::grow_over_faces() {
  up_.assign(mesh_.faces.size(), no_index);
  depth_.assign(mesh_.faces.size(), 0);
  std::vector<char> is_reached(mesh_.faces.size(), 0);
  for (Index root = 0; root < mesh_.faces.size(); ++root) {
    if (is_reached[root]) continue;
    is_reached[root] = 1;
    std::vector<Index> queue{root};
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (Index h = 3 * queue[i]; h < 3 * queue[i] + 3; ++h) {
        const Index other = opposites_[h] / 3;
        if (is_taken_[h] || is_reached[other]) continue;
        is_reached[other] = 1;
        up_[other] = opposites_[h];
        depth_[other] = depth_[queue[i]] + 1;
        take(h);
        queue.push_back(other);
      }
  }
}

// Adds a word, by exclusive or, to all halfedges that a loop of faces crosses. The loop crosses
// `halfedge`, and leads from both of its faces up the face tree to their common ancestor.
void Trees::add_loop(Index halfedge, HomologyWord word, std::vector<HomologyWord>& words) const {
  const auto cross = [&](Index h) {
    words[h] ^= word;
    words[opposites_[h]] ^= word;
  };
  cross(halfedge);
  Index first = halfedge / 3, second = opposites_[halfedge] / 3;
  while (first != second) {
    Index& deeper = depth_[first] < depth_[second] ? second : first;
    const Index up = up_[deeper];
    cross(up);
    deeper = opposites_[up] / 3;
  }
}

std::vector<HomologyWord> Trees::words() const {
  std::vector<HomologyWord> words(opposites_.size(), 0);
  HomologyWord count = 0;
  for (Index h = 0; h < opposites_.size(); ++h)
    if (!is_taken_[h] && h < opposites_[h]) add_loop(h, scattered(count++), words);
  return words;
}

}  // namespace

std::vector<HomologyWord> homology_words(const Mesh& mesh, const std::vector<Index>& opposites) {
  return Trees(mesh, opposites).words();
}

HomologyWord IndependentWords::remainder(HomologyWord word) const {
  for (const HomologyWord other : reduced_) word = std::min(word, word ^ other);
  return word;
}

void IndependentWords::add(HomologyWord word) {
  word = remainder(word);
  if (word == 0) return;
  reduced_.insert(std::upper_bound(reduced_.begin(), reduced_.end(), word, std::greater<>()), word);
}

}  // namespace transformesh

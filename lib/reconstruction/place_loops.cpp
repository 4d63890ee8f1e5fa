#include "reconstruction/place_loops.h"

#include <unordered_map>

#include "mesh/adjacency.h"

namespace transformesh {

PlaceLoops::PlaceLoops(const Mesh& mesh) : mesh_(mesh) {
  const auto opposites = closed_opposites(mesh, opposite_halfedges(mesh));
  if (!opposites) return;
  stars_.emplace(mesh, *opposites);
  words_ = homology_words(mesh, *opposites);
}

bool PlaceLoops::has_handle(const std::vector<Index>& vertices) const {
  if (!stars_ || vertices.empty()) return false;
  // Words of paths from the first vertex. Two paths to a vertex with different words are a loop
  // that does not separate the surface.
  std::unordered_map<Index, std::optional<HomologyWord>> word_to;
  for (const Index v : vertices) word_to[v];
  word_to[vertices.front()] = 0;
  bool is_found = false;
  for (const Index v : vertices) {
    stars_->visit(v, [&](Index halfedge) {
      const auto found = word_to.find(halfedge_target(mesh_, halfedge));
      if (found == word_to.end()) return;
      const HomologyWord word = *word_to[v] ^ words_[halfedge];
      is_found = is_found || found->second.value_or(word) != word;
      found->second = word;
    });
  }
  return is_found;
}

}  // namespace transformesh

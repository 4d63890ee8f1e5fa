#include "fill/short_loops.h"

#include <algorithm>
#include <optional>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "mesh/length_of.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

struct SurfaceAndWords {
  const Mesh& mesh;
  const HalfedgeStars& stars;
  const std::vector<HomologyWord>& words;

  double length(Index halfedge) const {
    return length_of(mesh.positions[halfedge_target(mesh, halfedge)] -
                     mesh.positions[halfedge_source(mesh, halfedge)]);
  }
};

/// The shortest paths from a base vertex. A loop consists of two paths and an edge between their
/// ends. Paths grow until the shortest non-separating loop through the base is found, or up to half
/// the largest length of a loop.
class Paths {
 public:
  Paths(const SurfaceAndWords& surface, Index base, double max_length);

  std::optional<ShortLoop> shortest_loop() const;

 private:
  struct Reached {
    double distance = 0;
    Index from = no_index;
    HomologyWord word = 0;
    bool is_final = false;
  };

  void leave(Index vertex);
  void close(Index halfedge, const Reached& here, const Reached& there);
  std::vector<Index> path_from(Index vertex) const;

  const SurfaceAndWords& surface_;
  /// Length of the shortest loop found so far; initially the largest allowed length.
  double shortest_;
  Index closing_ = no_index;
  std::unordered_map<Index, Reached> reached_;
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

// Grows the paths. Paths longer than half of the shortest loop found so far cannot close a shorter
// loop.
Paths::Paths(const SurfaceAndWords& surface, Index base, double max_length)
    : surface_(surface), shortest_(max_length) {
  reached_[base] = {};
  queue_.emplace(0, base);
  while (!queue_.empty() && queue_.top().first <= shortest_ / 2) {
    const Index vertex = queue_.top().second;
    queue_.pop();
    if (std::exchange(reached_[vertex].is_final, true)) continue;
    leave(vertex);
  }
}

void Paths::leave(Index vertex) {
  const Reached here = reached_[vertex];
  surface_.stars.visit(vertex, [&](Index h) {
    const double distance = here.distance + surface_.length(h);
    const Index target = halfedge_target(surface_.mesh, h);
    const auto [place, is_new] = reached_.try_emplace(target);
    Reached& there = place->second;
    if (!is_new && there.is_final) close(h, here, there);
    if (!is_new && !(distance < there.distance)) return;
    there = {distance, vertex, here.word ^ surface_.words[h], false};
    queue_.emplace(distance, target);
  });
}

void Paths::close(Index halfedge, const Reached& here, const Reached& there) {
  if ((here.word ^ there.word ^ surface_.words[halfedge]) == 0) return;
  const double length = here.distance + there.distance + surface_.length(halfedge);
  if (length > shortest_ || (length == shortest_ && closing_ != no_index)) return;
  shortest_ = length;
  closing_ = halfedge;
}

std::vector<Index> Paths::path_from(Index vertex) const {
  std::vector<Index> path;
  for (; vertex != no_index; vertex = reached_.at(vertex).from) path.push_back(vertex);
  return path;
}

// Returns the shortest loop that was found, or nothing. If both paths begin with the same edges,
// the loop does not contain these edges.
std::optional<ShortLoop> Paths::shortest_loop() const {
  if (closing_ == no_index) return std::nullopt;
  std::vector<Index> there = path_from(halfedge_source(surface_.mesh, closing_));
  std::vector<Index> back = path_from(halfedge_target(surface_.mesh, closing_));
  ShortLoop loop;
  loop.word =
      surface_.words[closing_] ^ reached_.at(there.front()).word ^ reached_.at(back.front()).word;
  while (there.size() > 1 && back.size() > 1 && there[there.size() - 2] == back[back.size() - 2]) {
    there.pop_back();
    back.pop_back();
  }
  loop.length = shortest_ - 2 * reached_.at(there.back()).distance;
  loop.vertices = std::move(there);
  loop.vertices.insert(loop.vertices.end(), back.rbegin() + 1, back.rend());
  return loop;
}

/// Returns the vertices at edges with nonzero words (homology.h), at which the search for loops
/// starts.
std::vector<Index> bases_of(const SurfaceAndWords& surface) {
  std::vector<Index> bases;
  for (Index h = 0; h < surface.words.size(); ++h)
    if (surface.words[h] != 0) bases.push_back(halfedge_source(surface.mesh, h));
  std::sort(bases.begin(), bases.end());
  bases.erase(std::unique(bases.begin(), bases.end()), bases.end());
  return bases;
}

}  // namespace

std::vector<ShortLoop> short_loops(const Mesh& mesh, const HalfedgeStars& stars, double max_length,
                                   const Progress& progress) {
  const std::vector<HomologyWord> words = homology_words(mesh, stars.opposites());
  const SurfaceAndWords surface{mesh, stars, words};
  const std::vector<Index> bases = bases_of(surface);
  std::vector<std::optional<ShortLoop>> found(bases.size());
  constexpr std::size_t at_once = 256;  // number of vertices between two reports of progress
  for (std::size_t begin = 0; begin < bases.size(); begin += at_once) {
    progress("find handles", static_cast<double>(begin) / static_cast<double>(bases.size()));
    const std::size_t count = std::min(at_once, bases.size() - begin);
    parallel_for(count, 8, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = begin + first; i < begin + last; ++i)
        found[i] = Paths(surface, bases[i], max_length).shortest_loop();
    });
  }

  std::vector<ShortLoop> loops;
  for (std::optional<ShortLoop>& loop : found)
    if (loop) loops.push_back(std::move(*loop));
  std::sort(loops.begin(), loops.end(), [](const ShortLoop& a, const ShortLoop& b) {
    return std::tie(a.length, a.vertices) < std::tie(b.length, b.vertices);
  });
  return loops;
}

}  // namespace transformesh

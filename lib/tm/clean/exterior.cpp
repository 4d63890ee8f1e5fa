#include "tm/clean/exterior.h"

#include <algorithm>
#include <limits>

#include "tm/clean/angular_order.h"
#include "tm/clean/winding_ray.h"
#include "tm/support/error.h"
#include "tm/support/parallel.h"

namespace transformesh {
namespace {

constexpr int unknown = std::numeric_limits<int>::min();

bool is_kept(int front, const Piece& piece, int level) {
  return front < level && front + piece.winding >= level;
}

// Across a curve, w behind or before one patch equals w before or behind the next.
struct Relation {
  Index patch;
  int offset;  ///< w in front of that patch, less w in front of this one
};

/// The patches of an arrangement and how their winding numbers depend on each other.
class Patches {
 public:
  explicit Patches(const Arrangement& arrangement);

  std::vector<Index> patch_of;  ///< per piece; no_index for pieces that cancel out
  std::vector<Index> seeds;     ///< per patch: its first piece
  std::vector<std::vector<Relation>> relations;

 private:
  bool is_inner_edge(std::span<const Index> halfedges) const;
  void number_patches(const Edges& edges);
  void relate_around(std::span<const Index> halfedges);

  const Arrangement& arrangement_;
};

Patches::Patches(const Arrangement& arrangement) : arrangement_(arrangement) {
  std::vector<char> counts(arrangement.pieces.size());
  for (std::size_t p = 0; p < counts.size(); ++p) counts[p] = arrangement.pieces[p].winding != 0;
  const Edges edges = piece_edges(arrangement, counts);
  number_patches(edges);
  relations.resize(seeds.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (!is_inner_edge(edges.halfedges(e))) relate_around(edges.halfedges(e));
  }
}

// An edge that a surface simply passes.
bool Patches::is_inner_edge(std::span<const Index> halfedges) const {
  const auto& pieces = arrangement_.pieces;
  return halfedges.size() == 2 &&
         is_forward(pieces, halfedges[0]) != is_forward(pieces, halfedges[1]) &&
         pieces[halfedges[0] / 3].winding == pieces[halfedges[1] / 3].winding;
}

void Patches::number_patches(const Edges& edges) {
  const auto& pieces = arrangement_.pieces;
  std::vector<Index> neighbor(3 * pieces.size(), no_index);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto halfedges = edges.halfedges(e);
    if (!is_inner_edge(halfedges)) continue;
    neighbor[halfedges[0]] = halfedges[1] / 3;
    neighbor[halfedges[1]] = halfedges[0] / 3;
  }
  patch_of.assign(pieces.size(), no_index);
  std::vector<Index> stack;
  for (Index first = 0; first < pieces.size(); ++first) {
    if (patch_of[first] != no_index || pieces[first].winding == 0) continue;
    const auto patch = static_cast<Index>(seeds.size());
    seeds.push_back(first);
    patch_of[first] = patch;
    stack.push_back(first);
    while (!stack.empty()) {
      const Index piece = stack.back();
      stack.pop_back();
      for (Index i = 0; i < 3; ++i) {
        const Index next = neighbor[3 * piece + i];
        if (next == no_index || patch_of[next] != no_index) continue;
        patch_of[next] = patch;
        stack.push_back(next);
      }
    }
  }
}

// Between neighbours in angular order lies one region: its w seen from both must agree.
void Patches::relate_around(std::span<const Index> halfedges) {
  if (halfedges.size() < 2) return;
  const std::vector<Index> sorted = sort_around_edge(arrangement_, halfedges);
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const Index a = sorted[i];
    const Index b = sorted[(i + 1) % sorted.size()];
    const int winding_a = arrangement_.pieces[a / 3].winding;
    const int winding_b = arrangement_.pieces[b / 3].winding;
    const int beyond_a = is_forward(arrangement_.pieces, a) ? 0 : winding_a;
    const int before_b = is_forward(arrangement_.pieces, b) ? winding_b : 0;
    const Index patch_a = patch_of[a / 3];
    const Index patch_b = patch_of[b / 3];
    if (patch_a == patch_b) continue;
    relations[patch_a].push_back({patch_b, beyond_a - before_b});
    relations[patch_b].push_back({patch_a, before_b - beyond_a});
  }
}

Exterior grow(const Arrangement& arrangement, int level,
              const std::vector<std::vector<Index>>& border_loops, const Progress& progress) {
  const Patches patches(arrangement);
  progress("exterior", 0.5);
  const WindingRay ray(arrangement, border_loops);
  const bool is_open = !border_loops.empty();

  Exterior result;
  result.patches = patches.seeds.size();
  std::vector<int> front(patches.seeds.size(), unknown);
  std::vector<Index> stack;
  for (Index seed = 0; seed < front.size(); ++seed) {
    if (front[seed] != unknown) continue;
    front[seed] = ray.in_front_of(arrangement.pieces[patches.seeds[seed]]);
    ++result.rays;
    stack.push_back(seed);
    while (!stack.empty()) {
      const Index patch = stack.back();
      stack.pop_back();
      const Piece& piece = arrangement.pieces[patches.seeds[patch]];
      if (is_open && !is_kept(front[patch], piece, level)) continue;
      for (const Relation& relation : patches.relations[patch]) {
        if (front[relation.patch] != unknown) continue;
        front[relation.patch] = front[patch] + relation.offset;
        stack.push_back(relation.patch);
      }
    }
  }

  result.kept.assign(arrangement.pieces.size(), 0);
  for (std::size_t p = 0; p < result.kept.size(); ++p) {
    const Index patch = patches.patch_of[p];
    if (patch != no_index) result.kept[p] = is_kept(front[patch], arrangement.pieces[p], level);
  }
  return result;
}

Exterior test_all(const Arrangement& arrangement, int level, const Progress& progress) {
  const WindingRay ray(arrangement, {});
  progress("exterior", 0.1);
  Exterior result;
  result.kept.assign(arrangement.pieces.size(), 0);
  result.rays = arrangement.pieces.size();
  for (std::size_t p = 0; p < result.kept.size(); ++p) {
    const Piece& piece = arrangement.pieces[p];
    result.kept[p] = piece.winding != 0 && is_kept(ray.in_front_of(piece), piece, level);
  }
  return result;
}

}  // namespace

Exterior find_exterior(const Arrangement& arrangement, int level, ExteriorMethod method,
                       const std::vector<std::vector<Index>>& border_loops,
                       const Progress& progress) {
  progress("exterior");
  Exterior result = method == ExteriorMethod::grow
                        ? grow(arrangement, level, border_loops, progress)
                        : test_all(arrangement, level, progress);
  if (std::find(result.kept.begin(), result.kept.end(), 1) == result.kept.end()) {
    throw GoalError(level == 1 ? "every winding number is <= 0: the mesh is inside out; reverse "
                                 "it with tm-stitch --flip"
                               : "no winding number reaches " + std::to_string(level) +
                                     ": nothing lies inside that many sheets");
  }
  return result;
}

}  // namespace transformesh

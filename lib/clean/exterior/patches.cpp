#include "clean/exterior/patches.h"

#include <algorithm>
#include <utility>

#include "clean/exterior/angular_order.h"

namespace transformesh {

Patches::Patches(const Arrangement& arrangement) : arrangement_(arrangement) {
  std::vector<char> counts(arrangement.pieces.size());
  for (std::size_t p = 0; p < counts.size(); ++p) {
    counts[p] = arrangement.pieces[p].multiplicity != 0 ? 1 : 0;
  }
  const Edges edges = piece_edges(arrangement, counts);
  number_patches(edges);
  relations.resize(pieces.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (!is_inner_edge(edges.halfedges(e))) relate_around(edges.halfedges(e));
  }
}

// Whether the surface goes on across the edge, and nothing else meets it there.
bool Patches::is_inner_edge(std::span<const Index> halfedges) const {
  const auto& all = arrangement_.pieces;
  return halfedges.size() == 2 && is_forward(all, halfedges[0]) != is_forward(all, halfedges[1]) &&
         all[halfedges[0] / 3].multiplicity == all[halfedges[1] / 3].multiplicity;
}

void Patches::number_patches(const Edges& edges) {
  const auto& all = arrangement_.pieces;
  std::vector<Index> neighbor(3 * all.size(), no_index);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto halfedges = edges.halfedges(e);
    if (!is_inner_edge(halfedges)) continue;
    neighbor[halfedges[0]] = halfedges[1] / 3;
    neighbor[halfedges[1]] = halfedges[0] / 3;
  }
  patch_of.assign(all.size(), no_index);
  for (Index first = 0; first < all.size(); ++first) {
    if (patch_of[first] == no_index && all[first].multiplicity != 0) collect_patch(first, neighbor);
  }
}

void Patches::collect_patch(Index first, const std::vector<Index>& neighbor) {
  const auto patch = static_cast<Index>(pieces.size());
  std::vector<Index> members{first};
  patch_of[first] = patch;
  for (std::size_t i = 0; i < members.size(); ++i) {
    for (Index k = 0; k < 3; ++k) {
      const Index next = neighbor[3 * members[i] + k];
      if (next == no_index || patch_of[next] != no_index) continue;
      patch_of[next] = patch;
      members.push_back(next);
    }
  }
  pieces.push_back(std::move(members));
}

// Whether the i-th piece around an edge has no partner behind it: one that has the opposite
// direction. Where a border lies on other faces, there is such a piece.
bool Patches::is_loose(const std::vector<Index>& sorted, std::size_t i) const {
  const bool forward = is_forward(arrangement_.pieces, sorted[i]);
  const std::size_t behind = forward ? i + sorted.size() - 1 : i + 1;
  return is_forward(arrangement_.pieces, sorted[behind % sorted.size()]) == forward;
}

// Whether w in front of one patch differs around the edge. In an open mesh a curve may end within a
// patch, which then lies on both of its sides.
bool Patches::is_ambiguous(const std::vector<Index>& sorted) const {
  std::vector<std::pair<Index, int>> fronts;
  int w = 0;
  for (const Index h : sorted) {
    const bool forward = is_forward(arrangement_.pieces, h);
    const int multiplicity = arrangement_.pieces[h / 3].multiplicity;
    const int beyond = w + (forward ? -multiplicity : multiplicity);
    fronts.emplace_back(patch_of[h / 3], forward ? beyond : w);
    w = beyond;
  }
  std::sort(fronts.begin(), fronts.end());
  return std::adjacent_find(fronts.begin(), fronts.end(), [](const auto& a, const auto& b) {
           return a.first == b.first && a.second != b.second;
         }) != fronts.end();
}

// Relates the patches of neighbors in angular order, as between them lies one region. A border
// tells nothing about the regions on its two sides, and an ambiguous edge nothing at all.
void Patches::relate_around(std::span<const Index> halfedges) {
  if (halfedges.size() < 2) return;
  const auto& all = arrangement_.pieces;
  int sum = 0;
  for (const Index h : halfedges) sum += (is_forward(all, h) ? 1 : -1) * all[h / 3].multiplicity;
  const std::vector<Index> sorted = sort_around_edge(arrangement_, halfedges);
  if (sum == 0 && is_ambiguous(sorted)) return;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const std::size_t next = (i + 1) % sorted.size();
    if (sum != 0 && (is_loose(sorted, i) || is_loose(sorted, next))) continue;
    relate(sorted[i], sorted[next]);
  }
}

void Patches::relate(Index a, Index b) {
  const auto& all = arrangement_.pieces;
  const Index patch_a = patch_of[a / 3], patch_b = patch_of[b / 3];
  if (patch_a == patch_b) return;
  const int beyond_a = is_forward(all, a) ? 0 : all[a / 3].multiplicity;
  const int before_b = is_forward(all, b) ? all[b / 3].multiplicity : 0;
  relations[patch_a].push_back({patch_b, beyond_a - before_b});
  relations[patch_b].push_back({patch_a, before_b - beyond_a});
}

}  // namespace transformesh

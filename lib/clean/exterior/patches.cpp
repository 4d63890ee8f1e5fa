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
}

// True if the surface continues across the edge: exactly two pieces meet there, traverse the edge
// in opposite directions, and have equal multiplicity (signed number of coincident faces).
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

// Sorts the pieces at each edge by angle. Joins the sides with which consecutive pieces face each
// other, because the same cell is in front of both sides. At a border, an edge of a single piece,
// this joins both sides of its patch.
DisjointSets join_sides_around_edges(const Arrangement& arrangement, const Patches& patches,
                                     const IsWholeEdge& is_whole) {
  DisjointSets sides(2 * patches.size());
  std::vector<char> counts(arrangement.pieces.size());
  for (std::size_t p = 0; p < counts.size(); ++p) counts[p] = patches.patch_of[p] != no_index;
  const Edges edges = piece_edges(arrangement, counts);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto halfedges = edges.halfedges(e);
    const auto patch = [&](Index h) { return patches.patch_of[h / 3]; };
    const auto forward = [&](Index h) { return is_forward(arrangement.pieces, h); };
    if (halfedges.size() == 2 && patch(halfedges[0]) == patch(halfedges[1]) &&
        forward(halfedges[0]) != forward(halfedges[1])) {
      continue;
    }
    if (is_whole && !is_whole(halfedges)) continue;
    const std::vector<Index> sorted = sort_around_edge(arrangement, halfedges);
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      const Index next = sorted[(i + 1) % sorted.size()];
      sides.join(2 * patch(sorted[i]) + (forward(sorted[i]) ? 0 : 1),
                 2 * patch(next) + (forward(next) ? 1 : 0));
    }
  }
  return sides;
}

void keep_boundary(Arrangement& arrangement, const Patches& patches,
                   const std::vector<char>& is_inside, std::vector<char>& kept) {
  for (std::size_t p = 0; p < kept.size(); ++p) {
    const Index patch = patches.patch_of[p];
    if (patch == no_index) continue;
    const char front = is_inside[std::size_t{2} * patch];
    const char behind = is_inside[std::size_t{2} * patch + 1];
    if (front > 1 || behind > 1) continue;
    kept[p] = front != behind ? 1 : 0;
    if (kept[p] && front) reverse_piece(arrangement, arrangement.pieces[p]);
  }
}

}  // namespace transformesh

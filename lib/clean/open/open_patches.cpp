#include "clean/open/open_patches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "clean/exterior/angular_order.h"
#include "clean/open/border_strips.h"
#include "clean/open/component_winding.h"
#include "clean/open/own_numbers.h"
#include "clean/open/passages.h"
#include "clean/open/patch_numbers.h"
#include "mesh/disjoint_sets.h"

namespace transformesh {
namespace {

constexpr Index closed_part = ComponentWinding::closed_part;
/// Areas whose relative difference is smaller than this count as equal.
constexpr double area_rounding = 1e-9;

class PatchFinder {
 public:
  PatchFinder(const Arrangement& arrangement, int winding_level, Scalar coordinate)
      : arrangement_(arrangement),
        winding_level_(winding_level),
        coordinate_(coordinate),
        connected_(3 * arrangement.pieces.size(), no_index),
        sets_(arrangement.pieces.size()),
        winding_(arrangement),
        own_numbers_(arrangement, winding_) {}
  OpenPatches find();

 private:
  /// An edge at which a component passes through another one.
  struct Crossing {
    /// Pieces of one component, in front of and behind the other component.
    Index front, back;
    Index one, other;
    double length;
  };
  Index component(Index piece) const { return winding_.component_of(piece); }
  bool is_cut(Index halfedge) const { return halfedge / 3 >= arrangement_.whole_pieces; }
  void connect(Index halfedge, Index other);
  void visit_edge(std::span<const Index> halfedges);
  void visit_curve(std::span<const Index> halfedges);
  std::vector<Passage> passages_at(std::span<const Index> sorted);
  bool cross(const std::vector<Index>& sorted, const Passage& one, const Passage& other);
  void measure_curves();
  int front_of(const Piece& piece) const;
  void decide();
  void find_strips(const Edges& edges);
  void drop_strips();
  int unpaired_direction(std::span<const Index> halfedges) const;
  bool drop_unpaired(const Edges& edges);
  void drop(const std::set<Index>& patches);

  const Arrangement& arrangement_;
  int winding_level_;
  Scalar coordinate_;
  /// The halfedge of the connected piece across the edge of each halfedge, or `no_index`.
  std::vector<Index> connected_;
  DisjointSets sets_;  ///< sets of connected pieces; in the end each set is a patch
  ComponentWinding winding_;
  OwnNumbers own_numbers_;
  /// For each strip along a border (a set of pieces), the pieces beside it.
  std::map<Index, std::vector<Index>> strips_;
  std::vector<Crossing> crossings_;
  CutPatches patches_;
  OpenPatches result_;
};

// Connects two pieces, except pieces of faces that cancel each other out.
void PatchFinder::connect(Index halfedge, Index other) {
  if (arrangement_.pieces[halfedge / 3].multiplicity == 0 ||
      arrangement_.pieces[other / 3].multiplicity == 0)
    return;
  connected_[halfedge] = other;
  connected_[other] = halfedge;
}

// Connects the two pieces at an edge of two pieces. An edge of more pieces is part of an
// intersection curve, and is handled by visit_curve().
void PatchFinder::visit_edge(std::span<const Index> halfedges) {
  const auto& pieces = arrangement_.pieces;
  if (halfedges.size() > 2) return visit_curve(halfedges);
  if (halfedges.size() == 2 && is_forward(pieces, halfedges[0]) != is_forward(pieces, halfedges[1]))
    connect(halfedges[0], halfedges[1]);
}

// Finds the passages at an edge. Notes the components that intersect themselves there.
std::vector<Passage> PatchFinder::passages_at(std::span<const Index> sorted) {
  Passages passages = find_passages(arrangement_, winding_, sorted);
  if (std::ranges::any_of(sorted, [&](Index h) { return is_cut(h); }))
    for (const Index component : passages.multiple)
      if (component != closed_part) patches_.self_intersecting.insert(component);
  std::set<Index> own;
  for (const Index h : sorted) own.insert(component(h / 3));
  own.erase(closed_part);
  for (const Index component : own) own_numbers_.add_edge(sorted, component);
  return std::move(passages.single);
}

void PatchFinder::visit_curve(std::span<const Index> halfedges) {
  const std::vector<Index> sorted = sort_around_edge(arrangement_, halfedges);
  const std::vector<Passage> passages = passages_at(sorted);
  for (const Passage& one : passages) {
    bool is_crossed = false;
    for (const Passage& other : passages)
      if (other.component != one.component) is_crossed |= cross(sorted, one, other);
    const Index forward = sorted[one.forward], backward = sorted[one.backward];
    if (!is_crossed && component(forward / 3) == one.component &&
        component(backward / 3) == one.component)
      connect(forward, backward);
  }
}

// Returns true if the pieces of `one` at an edge are on different sides of `other`. Records this if
// `other` is open.
bool PatchFinder::cross(const std::vector<Index>& sorted, const Passage& one,
                        const Passage& other) {
  const auto sides = sides_of(sorted, one, other);
  if (!sides) return false;
  if (other.component == closed_part) return true;
  const Index h = sorted.front();
  const double length = (arrangement_.position(halfedge_target(arrangement_.pieces, h)) -
                         arrangement_.position(halfedge_source(arrangement_.pieces, h)))
                            .stableNorm();
  crossings_.push_back({sides->front, sides->back, one.component, other.component, length});
  return true;
}

void PatchFinder::measure_curves() {
  std::sort(crossings_.begin(), crossings_.end(),
            [](const Crossing& a, const Crossing& b) { return a.length < b.length; });
  for (const Crossing& c : crossings_) {
    const Index front = sets_.find(c.front), back = sets_.find(c.back);
    if (front == back) continue;
    patches_.curves[{front, c.other}].front += c.length;
    patches_.curves[{back, c.other}].behind += c.length;
    patches_.intersecting[c.one].insert(c.other);
  }
}

// Returns the winding number of the closed part in front of a piece. A closed piece is on the
// boundary of the region with winding number >= winding level. Hence the winding number in front is
// winding level - 1 if the multiplicity of the piece is 1.
int PatchFinder::front_of(const Piece& piece) const {
  if (piece.is_open) return std::max(piece.front, 0);
  return piece.multiplicity == 1 ? winding_level_ - 1 : piece.front;
}

// Joins connected pieces to patches and strips.
void PatchFinder::find_strips(const Edges& edges) {
  const auto sides = disconnect_border_strips(arrangement_, edges, coordinate_, connected_);
  for (Index h = 0; h < connected_.size(); ++h)
    if (connected_[h] != no_index) sets_.join(h / 3, connected_[h] / 3);
  for (const auto& [piece, beside] : sides) strips_[sets_.find(piece)].push_back(beside);
}

OpenPatches PatchFinder::find() {
  const auto& pieces = arrangement_.pieces;
  std::vector<char> counts(pieces.size());
  for (std::size_t p = 0; p < counts.size(); ++p) counts[p] = pieces[p].multiplicity != 0 ? 1 : 0;
  // Components also pass through edges at pieces that cancel each other out.
  const Edges all = piece_edges(arrangement_, std::vector<char>(pieces.size(), 1));
  for (std::size_t e = 0; e < all.size(); ++e) visit_edge(all.halfedges(e));
  const Edges edges = piece_edges(arrangement_, counts);
  find_strips(edges);
  measure_curves();
  for (Index p = 0; p < pieces.size(); ++p)
    if (counts[p]) patches_.pieces[sets_.find(p)].push_back(p);

  decide();
  drop_strips();
  while (drop_unpaired(edges)) drop_strips();
  return std::move(result_);
}

void PatchFinder::decide() {
  const auto& pieces = arrangement_.pieces;
  result_.kept.assign(pieces.size(), 0);
  result_.patches = patches_.pieces.size() - strips_.size();
  PatchNumbers numbers(patches_, winding_, own_numbers_);
  for (const auto& [patch, members] : patches_.pieces) {
    if (strips_.contains(patch)) {
      for (const Index p : members) result_.kept[p] = 1;
      continue;
    }
    const auto [count, is_by_winding] = numbers.hiding(patch);
    result_.decided_by_number += is_by_winding ? 1 : 0;
    for (const Index p : members) {
      const int front = front_of(pieces[p]) + count;
      const bool is_boundary =
          front < winding_level_ && front + pieces[p].multiplicity >= winding_level_;
      result_.kept[p] = is_boundary ? 1 : 0;
    }
  }
  result_.least_margin = numbers.least_margin();
}

// Drops strips beside dropped pieces. Such a strip could be a needle along the border.
void PatchFinder::drop_strips() {
  const auto is_dropped = [&](Index piece) { return !result_.kept[piece]; };
  std::set<Index> dropped;
  for (const auto& [strip, beside] : strips_)
    if (std::ranges::any_of(beside, is_dropped)) dropped.insert(strip);
  drop(dropped);
}

// Returns the direction in which kept pieces traverse an edge without partners of opposite
// direction: 1 for forward, -1 for backward. Returns 0 if there are fewer than two such pieces, or
// not more than in the input.
int PatchFinder::unpaired_direction(std::span<const Index> halfedges) const {
  std::ptrdiff_t before = 0, after = 0;
  for (const Index h : halfedges) {
    const int direction = is_forward(arrangement_.pieces, h) ? 1 : -1;
    before += direction;
    if (result_.kept[h / 3]) after += direction;
  }
  if (std::abs(after) < 2 || std::abs(after) <= std::abs(before)) return 0;
  return after > 0 ? 1 : -1;
}

// Drops patches at edges of more than two pieces where pieces have no partners. At each such edge
// drops the smallest patch of the prevailing direction, and all that are as small. Returns true if
// it dropped any.
bool PatchFinder::drop_unpaired(const Edges& edges) {
  std::set<Index> dropped;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto halfedges = edges.halfedges(e);
    const int direction = halfedges.size() > 2 ? unpaired_direction(halfedges) : 0;
    if (direction == 0) continue;
    std::map<Index, double> areas;
    for (const Index h : halfedges)
      if (result_.kept[h / 3] && is_forward(arrangement_.pieces, h) == (direction > 0))
        areas[sets_.find(h / 3)] = winding_.area_of(patches_.pieces.at(sets_.find(h / 3)));
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [patch, area] : areas) least = std::min(least, area);
    for (const auto& [patch, area] : areas)
      if (area <= (1 + area_rounding) * least) dropped.insert(patch);
  }
  drop(dropped);
  return !dropped.empty();
}

void PatchFinder::drop(const std::set<Index>& patches) {
  for (const Index patch : patches)
    for (const Index p : patches_.pieces.at(patch)) result_.kept[p] = 0;
}

}  // namespace

OpenPatches find_exterior_patches(const Arrangement& arrangement, int winding_level,
                                  Scalar coordinate) {
  return PatchFinder(arrangement, winding_level, coordinate).find();
}

}  // namespace transformesh

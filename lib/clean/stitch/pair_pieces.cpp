#include "clean/stitch/pair_pieces.h"

#include <algorithm>

#include "clean/exterior/angular_order.h"
#include "clean/stitch/pair_halfedges.h"
#include "support/numbered_selection.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

class PiecePairing {
 public:
  PiecePairing(const Arrangement& arrangement, const std::vector<char>& kept)
      : arrangement_(arrangement), welded_(*arrangement.welded), kept_(kept) {}
  PiecePairs pair();

 private:
  Index face_of(Index piece) const {
    return arrangement_.sources_of(arrangement_.pieces[piece]).front().face;
  }
  void find_pieces_of_faces();
  bool pair_as_welded(Index piece);
  void pair_others(const std::vector<char>& has_other);

  const Arrangement& arrangement_;
  const WeldedMesh& welded_;
  const std::vector<char>& kept_;
  /// For each face of the welded mesh that is kept as it is, neither cut nor reversed: its piece.
  /// no_index for all other faces.
  std::vector<Index> piece_of_;
  PiecePairs result_;
};

// Fills `piece_of_`. A face that is kept with reversed orientation gets no_index, because the
// corners of its piece are in a different order.
void PiecePairing::find_pieces_of_faces() {
  piece_of_.assign(welded_.faces.size(), no_index);
  parallel_for_each(arrangement_.whole_pieces, [&](Index p) {
    const Index face = face_of(p);
    if (kept_[p] && arrangement_.pieces[p].corners == welded_.faces[face]) piece_of_[face] = p;
  });
}

// Pairs the halfedges of an uncut piece with those of neighboring uncut pieces. Only edges of two
// welded faces that are both kept and uncut are considered. No piece of a cut face is at such an
// edge, because the cut face would intersect both faces. Returns false if the piece has any other
// edge.
bool PiecePairing::pair_as_welded(Index piece) {
  Index* const opposite = result_.opposite.data() + std::size_t{3} * piece;
  std::fill_n(opposite, 3, no_index);
  if (!kept_[piece]) return true;
  const Index face = face_of(piece);
  if (piece >= arrangement_.whole_pieces || piece_of_[face] != piece) return false;
  bool has_other = false;
  for (Index i = 0; i < 3; ++i) {
    const Index across = welded_.opposites[3 * face + i];
    const Index other = across == no_index ? no_index : piece_of_[across / 3];
    if (other != no_index) opposite[i] = 3 * other + across % 3;
    has_other |= other == no_index;
  }
  return !has_other;
}

// Pairs the remaining pieces, for which pair_as_welded() returned false. These pieces form a
// smaller mesh in the same order, to which pair_across_inside() is applied.
void PiecePairing::pair_others(const std::vector<char>& has_other) {
  const NumberedSelection selection(has_other.size(),
                                    [&](std::size_t p) { return has_other[p] != 0; });
  RawVector<Index> pieces(selection.size());
  RawVector<Face> faces(pieces.size());
  const bool has_open = !welded_.open_component.empty();
  RawVector<Index> component_of(has_open ? pieces.size() : 0);
  selection.visit([&](std::size_t p, std::size_t n) {
    pieces[n] = static_cast<Index>(p);
    faces[n] = arrangement_.pieces[p].corners;
    if (has_open) component_of[n] = welded_.open_component[face_of(pieces[n])];
  });
  const auto sort = [&](std::span<const Index> halfedges) {
    std::vector<Index> of_pieces;
    for (const Index h : halfedges) of_pieces.push_back(3 * pieces[h / 3] + h % 3);
    std::vector<Index> sorted = sort_around_edge(arrangement_, of_pieces);
    for (Index& h : sorted) {
      const auto at = std::find(of_pieces.begin(), of_pieces.end(), h) - of_pieces.begin();
      h = halfedges[static_cast<std::size_t>(at)];
    }
    return sorted;
  };
  const Edges edges(faces, arrangement_.point_count());
  const std::vector<Index> paired = pair_across_inside(faces, edges, sort, component_of);
  parallel_for_each(paired.size(), [&](Index h) {
    if (paired[h] == no_index) return;
    result_.opposite[3 * pieces[h / 3] + h % 3] = 3 * pieces[paired[h] / 3] + paired[h] % 3;
  });
  result_.has_singular_edges = NumberedSelection(edges.size(), [&](std::size_t e) {
                                 return edges.halfedges(e).size() > 2;
                               }).size() > 0;
}

PiecePairs PiecePairing::pair() {
  const std::size_t count = arrangement_.pieces.size();
  find_pieces_of_faces();
  result_.opposite.resize(3 * count);
  std::vector<char> has_other(count);
  parallel_for_each(count, [&](Index p) { has_other[p] = pair_as_welded(p) ? 0 : 1; });
  pair_others(has_other);
  return std::move(result_);
}

}  // namespace

PiecePairs pair_pieces(const Arrangement& arrangement, const std::vector<char>& kept) {
  return PiecePairing(arrangement, kept).pair();
}

std::vector<Index> opposites_of_kept(const RawVector<Index>& opposite,
                                     const std::vector<char>& kept, std::size_t count) {
  std::vector<Index> number_of(kept.size());
  std::vector<Index> result(3 * count);
  const NumberedSelection selection(kept.size(), [&](std::size_t p) { return kept[p] != 0; });
  selection.visit([&](std::size_t p, std::size_t n) { number_of[p] = static_cast<Index>(n); });
  selection.visit([&](std::size_t p, std::size_t n) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index across = opposite[3 * p + i];
      result[3 * n + i] = across == no_index ? no_index : 3 * number_of[across / 3] + across % 3;
    }
  });
  return result;
}

}  // namespace transformesh

#include "tm/remesh/flip.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tm/remesh/slab_edits.h"
#include "tm/remesh/star.h"
#include "tm/remesh/where.h"

namespace transformesh {
namespace {

constexpr double least_cosine = 0.5;
/// The cosine of 20 degrees: below that, a flip for valence may not make the least angle smaller.
constexpr double narrow = 0.9396926207859084;
/// A stretched edge may pass the old one at this distance, as a share of its length.
constexpr double farthest_shift = 0.012;
/// Angles must grow by more than rounding, so that no edge flips to and fro.
constexpr double least_gain = 1e-9;

/// What the flips of a mesh have in common, in all its slabs.
struct FlipBoard {
  std::vector<int> excess;          ///< per vertex: valence minus what it should be
  std::vector<std::uint8_t> waits;  ///< per halfedge: whether its edge waits for a visit

  explicit FlipBoard(const EditableMesh& mesh)
      : excess(mesh.vertex_slots(), -6), waits(mesh.halfedge_slots(), 0) {
    for (Index h = 0; h < mesh.halfedge_slots(); ++h) {
      if (!mesh.has_halfedge(h)) continue;
      ++excess[mesh.source(h)];
      // A border vertex has one edge more than faces, and should have four edges.
      if (mesh.is_border(h)) excess[mesh.source(h)] += 3;
    }
  }
};

class Flipper {
 public:
  Flipper(EditableMesh& mesh, EmbeddingGuard& guard, FlipRule rule, const EdgeLimits& limits)
      : mesh_(mesh), guard_(guard), rule_(rule), limits_(limits) {}

  /// The edges that are to be flipped, ascending.
  std::vector<Index> wanted(const FlipBoard& board) const;
  /// Flips those of the edges that still are to be, and then what that changes around them. Puts
  /// into `left` what lies elsewhere.
  EditCounts run(std::span<const Index> edges, FlipBoard& board, std::vector<Index>& left,
                 const Progress& progress);
  bool flip(Index halfedge);

 private:
  struct Corners {
    Index from, to, left, right;
  };
  Corners corners(Index h) const {
    return {mesh_.source(h), mesh_.target(h), mesh_.apex(h), mesh_.apex(mesh_.opposite(h))};
  }
  struct Positions {
    const Vec3 &a, &b, &c, &d;
  };
  Positions positions(const Corners& at) const {
    return {mesh_.position(at.from), mesh_.position(at.to), mesh_.position(at.left),
            mesh_.position(at.right)};
  }

  bool is_wanted(Index halfedge, const FlipBoard& board) const;
  void note_change(const Corners& at, FlipBoard& board);
  bool gains_angle(const Corners& at, bool only_not_narrow) const;
  bool is_too_long(const Corners& at) const;
  bool is_sound(Index halfedge, const Corners& at) const;
  bool attempt(Index halfedge);
  void wait(Index halfedge, FlipBoard& board);

  EditableMesh& mesh_;
  EmbeddingGuard& guard_;
  FlipRule rule_;
  EdgeLimits limits_;
  std::vector<Index> queue_;
  Patch patch_;
  std::size_t refused_ = 0;
};

/// By how much the squared deviations from the valences wanted get smaller.
int deviation_gain(int from, int to, int left, int right) {
  // Each end gains x^2 - (x - 1)^2, each apex x^2 - (x + 1)^2.
  return 2 * (from + to - left - right) - 4;
}

bool Flipper::gains_angle(const Corners& at, bool only_not_narrow) const {
  const auto [a, b, c, d] = positions(at);
  const double after =
      std::max(cosine_of_smallest_angle(a, d, c), cosine_of_smallest_angle(b, c, d));
  if (only_not_narrow && after < narrow) return true;
  const double before =
      std::max(cosine_of_smallest_angle(a, b, c), cosine_of_smallest_angle(a, d, b));
  return after < before - least_gain;
}

bool Flipper::is_wanted(Index halfedge, const FlipBoard& board) const {
  if (mesh_.is_border(halfedge)) return false;
  const Corners at = corners(halfedge);
  if (rule_ == FlipRule::angle) return gains_angle(at, false);
  const int gain = deviation_gain(board.excess[at.from], board.excess[at.to], board.excess[at.left],
                                  board.excess[at.right]);
  if (gain < 0) return false;
  return gains_angle(at, gain > 0);
}

// Valences are asked before which halfedge names the edge, as few edges pass.
std::vector<Index> Flipper::wanted(const FlipBoard& board) const {
  return indices_where_in(mesh_.face_slots(), [&](Index face, std::vector<Index>& found) {
    if (!mesh_.has_face(face)) return;
    std::array<int, 3> excess;
    for (Index i = 0; i < 3; ++i) excess[i] = board.excess[mesh_.source(3 * face + i)];
    for (Index i = 0; i < 3; ++i) {
      const Index h = 3 * face + i;
      const Index opposite = mesh_.opposite(h);
      if (opposite == no_index) continue;
      const int gain = deviation_gain(excess[i], excess[(i + 1) % 3], excess[(i + 2) % 3],
                                      board.excess[mesh_.apex(opposite)]);
      const bool is_candidate = gain >= 0 || rule_ == FlipRule::angle;
      if (is_candidate && h < opposite && is_wanted(h, board)) found.push_back(h);
    }
  });
}

void Flipper::wait(Index halfedge, FlipBoard& board) {
  if (mesh_.is_border(halfedge)) return;
  const Index edge = std::min(halfedge, mesh_.opposite(halfedge));
  if (board.waits[edge] != 0) return;
  board.waits[edge] = 1;
  queue_.push_back(edge);
}

/// After a flip, whose corners were these: all edges of which they are corners may be wanted now.
void Flipper::note_change(const Corners& at, FlipBoard& board) {
  --board.excess[at.from];
  --board.excess[at.to];
  ++board.excess[at.left];
  ++board.excess[at.right];
  for (const Index corner : {at.from, at.to, at.left, at.right}) {
    mesh_.for_each_outgoing(corner, [&](Index halfedge) {
      wait(halfedge, board);
      wait(next_halfedge(halfedge), board);
    });
  }
}

bool Flipper::is_too_long(const Corners& at) const {
  const Vec3& a = mesh_.position(at.from);
  const Vec3& c = mesh_.position(at.left);
  const Vec3 before = mesh_.position(at.to) - a;
  const Vec3 after = mesh_.position(at.right) - c;
  const double length = after.norm();
  const double scaled = length / mesh_.mean_size(at.left, at.right);
  if (scaled <= limits_.longest || scaled > limits_.stretched()) return scaled > limits_.longest;

  // The mixed product gives the distance between the old edge and the new one.
  const Vec3 across = before.cross(after);
  return std::abs(across.dot(c - a)) > farthest_shift * length * across.norm();
}

bool Flipper::is_sound(Index halfedge, const Corners& at) const {
  const auto [a, b, c, d] = positions(at);
  if ((d - c).squaredNorm() > mesh_.squared_length(halfedge) && is_too_long(at)) return false;

  // All four triangles have to look the same way.
  const Vec3 left = normal_of(a, b, c);
  const Vec3 right = normal_of(a, d, b);
  const Vec3 first = normal_of(a, d, c);
  const Vec3 second = normal_of(b, c, d);
  const Vec3 mean = left + right;
  const bool flat_left = left.squaredNorm() == 0;
  const bool flat_right = right.squaredNorm() == 0;
  if (!flat_left && !flat_right && turns(left, right, least_cosine)) return false;
  return !turns(mean, first, least_cosine) && !turns(mean, second, least_cosine) &&
         !turns(first, second, least_cosine);
}

bool Flipper::attempt(Index halfedge) {
  const Corners at = corners(halfedge);
  const auto [a, b, c, d] = positions(at);
  patch_.center = at.from;
  patch_.center_position = a;
  patch_.made.assign({Triangle{c, a, d}, Triangle{d, b, c}});
  patch_.normals.assign({normal_of(c, a, d), normal_of(d, b, c)});
  patch_.longest_squared =
      std::max({(d - c).squaredNorm(), (c - a).squaredNorm(), (d - a).squaredNorm(),
                (c - b).squaredNorm(), (d - b).squaredNorm()});
  patch_.replaced.assign({halfedge / 3, mesh_.opposite(halfedge) / 3});
  patch_.vertices.assign({at.from, at.to, at.left, at.right});
  if (!guard_.allows(patch_)) {
    ++refused_;
    return false;
  }
  mesh_.flip(halfedge);
  guard_.commit(patch_);
  return true;
}

bool Flipper::flip(Index halfedge) {
  if (mesh_.is_border(halfedge) || mesh_.is_feature(halfedge)) return false;
  return mesh_.can_flip(halfedge) && is_sound(halfedge, corners(halfedge)) && attempt(halfedge);
}

// Every flip lowers a bounded measure, but in rounded arithmetic a limit is safer than a proof.
EditCounts Flipper::run(std::span<const Index> edges, FlipBoard& board, std::vector<Index>& left,
                        const Progress& progress) {
  EditCounts counts;
  const std::size_t most = 20 * std::size_t{mesh_.halfedge_slots()};
  for (const Index edge : edges) wait(edge, board);
  for (std::size_t next = 0; next < queue_.size() && next < most; ++next) {
    if (next % 16384 == 16383 && !guard_.is_part())
      progress("flip", static_cast<double>(next) / static_cast<double>(queue_.size()));
    const Index edge = queue_[next];
    board.waits[edge] = 0;
    if (!guard_.may_edit(mesh_.source(edge))) {
      left.push_back(edge);
      continue;
    }
    if (!is_wanted(edge, board)) continue;
    const Corners at = corners(edge);
    if (!flip(edge)) continue;
    ++counts.done;
    note_change(at, board);
  }
  counts.refused = refused_;
  return counts;
}

}  // namespace

FlipCounts flip_edges(EditableMesh& mesh, EmbeddingGuard& guard, FlipRule rule,
                      const EdgeLimits& limits, const Progress& progress) {
  if (rule == FlipRule::none) return {};
  progress("flip");
  FlipBoard board(mesh);
  const std::vector<Halfedges> wanted =
      sorted_by_slab(mesh, guard.slabs(), Flipper(mesh, guard, rule, limits).wanted(board));
  const EditCounts counts = edit_in_slabs(
      guard, [&](std::size_t slab) -> const Halfedges& { return wanted[slab]; },
      [&](EmbeddingGuard& own, std::span<const Index> edges, std::vector<Index>& left) {
        return Flipper(mesh, own, rule, limits).run(edges, board, left, progress);
      });
  return {counts.done, counts.refused};
}

bool flip_edge(EditableMesh& mesh, EmbeddingGuard& guard, Index halfedge,
               const EdgeLimits& limits) {
  return Flipper(mesh, guard, FlipRule::angle, limits).flip(halfedge);
}

}  // namespace transformesh

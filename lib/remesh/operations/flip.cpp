#include "remesh/operations/flip.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "remesh/guards/edge_rules.h"
#include "remesh/halfedges/triangle_quality.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

/// Cosine of 60 degrees; chosen by hand, not measured.
constexpr double least_cosine = 0.5;
constexpr std::size_t faces_per_task = 2048;  ///< affects time only
/// The cosine of 20 degrees. A flip for valence may not decrease the least angle below 20 degrees.
constexpr double narrow = 0.9396926207859084;
/// If a flip makes an edge longer than the limit, but within EdgeLimits::stretched(), it may move
/// the surface by at most this share of the edge. Larger values allow more flips and worse shapes.
constexpr double farthest_shift = 0.012;
/// The cosine of the least angle must decrease by more than rounding errors, so that no edge flips
/// back and forth.
constexpr double least_gain = 1e-9;

class Flipper {
 public:
  Flipper(EditableMesh& mesh, EmbeddingGuard& guard, FlipRule rule, const EdgeLimits& limits)
      : mesh_(mesh), guard_(guard), rule_(rule), limits_(limits) {}

  FlipCounts run(const Progress& progress);
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

  void count_valences();
  bool is_wanted(Index halfedge) const;
  void look_ahead();
  void note_change(const Corners& at);
  bool gains_angle(const Corners& at, bool only_not_narrow) const;
  bool is_too_long(const Corners& at) const;
  bool is_sound(Index halfedge, const Corners& at) const;
  bool attempt(Index halfedge);
  bool visit(Index halfedge);
  void push_around(Index halfedge);

  EditableMesh& mesh_;
  EmbeddingGuard& guard_;
  FlipRule rule_;
  EdgeLimits limits_;
  std::vector<int> excess_;  ///< valence of each vertex minus 6, or minus 4 on borders
  std::vector<Index> queue_;
  /// State of a halfedge. `edge`: the halfedge was the lower halfedge of its edge before the first
  /// flip; only such halfedges are visited. `wanted_before`: look_ahead() wanted to flip the edge.
  /// `changed`: a flip nearby may have changed the result of look_ahead(). `queued`: the halfedge
  /// is in the queue.
  using State = std::uint8_t;
  enum : State { edge = 1, wanted_before = 2, changed = 4, queued = 8 };
  std::vector<State> states_;
  /// All edges whose lower halfedge is below this index were visited. They are visited again only
  /// from the queue.
  Index swept_ = 0;
  Patch patch_;
  std::size_t refused_ = 0;
};

void Flipper::count_valences() {
  excess_.assign(mesh_.vertex_slots(), -6);
  for (Index h = 0; h < mesh_.halfedge_slots(); ++h) {
    if (!mesh_.has_halfedge(h)) continue;
    ++excess_[mesh_.source(h)];
    // A border vertex has one more edge than faces and should have four edges.
    if (mesh_.is_border(h)) excess_[mesh_.source(h)] += 3;
  }
}

/// Returns the decrease, by a flip, of the sum of squared deviations from ideal valences. The
/// arguments are the signed deviations before the flip.
int deviation_gain(int from, int to, int left, int right) {
  // If x is a vertex's deviation, the decrease is x^2 - (x - 1)^2 at each end and x^2 - (x + 1)^2
  // at each apex.
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

bool Flipper::is_wanted(Index halfedge) const {
  const Corners at = corners(halfedge);
  if (rule_ == FlipRule::angle) return gains_angle(at, false);
  const int gain =
      deviation_gain(excess_[at.from], excess_[at.to], excess_[at.left], excess_[at.right]);
  if (gain < 0) return false;
  return gains_angle(at, gain > 0);
}

/// Tests all edges in parallel before the first flip. Edges that a flip changes are tested again
/// later. Valences are tested before angles, because few edges pass the test of valences.
void Flipper::look_ahead() {
  states_.assign(mesh_.halfedge_slots(), 0);
  parallel_for(mesh_.face_slots(), faces_per_task, [&](std::size_t first, std::size_t last) {
    for (auto face = static_cast<Index>(first); face < last; ++face) {
      if (!mesh_.has_face(face)) continue;
      std::array<int, 3> excess;
      for (Index i = 0; i < 3; ++i) excess[i] = excess_[mesh_.source(3 * face + i)];
      for (Index i = 0; i < 3; ++i) {
        const Index h = 3 * face + i;
        const Index opposite = mesh_.opposite(h);
        states_[h] = static_cast<State>(h < opposite ? edge : 0);
        if (opposite == no_index) continue;
        // The comparison of both halfedges is an unpredictable branch, so it comes after the test
        // that rejects most edges.
        const int gain = deviation_gain(excess[i], excess[(i + 1) % 3], excess[(i + 2) % 3],
                                        excess_[mesh_.apex(opposite)]);
        if ((gain >= 0 || rule_ == FlipRule::angle) && h < opposite && is_wanted(h))
          states_[h] |= wanted_before;
      }
    }
  });
}

/// Updates valences and states after a flip. `at` holds the corners of both faces of the flipped
/// edge.
void Flipper::note_change(const Corners& at) {
  --excess_[at.from];
  --excess_[at.to];
  ++excess_[at.left];
  ++excess_[at.right];
  for (const Index corner : {at.from, at.to, at.left, at.right}) {
    mesh_.for_each_outgoing(corner, [&](Index halfedge) {
      const Index rim = next_halfedge(halfedge);
      for (const Index h : {halfedge, rim, previous_halfedge(halfedge), mesh_.opposite(rim)})
        if (h != no_index) states_[h] |= changed;
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

  // The scalar triple product yields the distance between the lines of the old and the new edge.
  const Vec3 across = before.cross(after);
  return std::abs(across.dot(c - a)) > farthest_shift * length * across.norm();
}

bool Flipper::is_sound(Index halfedge, const Corners& at) const {
  const auto [a, b, c, d] = positions(at);
  if ((d - c).squaredNorm() > mesh_.squared_length(halfedge) && is_too_long(at)) return false;

  // The normals of both old and both new faces must be similar.
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
  patch_.normals.assign({reliable_normal(c, a, d), reliable_normal(d, b, c)});
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

void Flipper::push_around(Index halfedge) {
  for (const Index h : {halfedge, mesh_.opposite(halfedge)}) {
    for (const Index rim : {next_halfedge(h), previous_halfedge(h)}) {
      if (mesh_.is_border(rim)) continue;
      const Index named = std::min(rim, mesh_.opposite(rim));
      if (named >= swept_ || (states_[named] & (edge | queued)) != edge) continue;
      states_[named] |= queued;
      queue_.push_back(named);
    }
  }
}

bool Flipper::visit(Index halfedge) {
  State& state = states_[halfedge];
  state &= static_cast<State>(~queued);
  if ((state & (wanted_before | changed)) == 0) return false;
  if ((state & changed) != 0 && (mesh_.is_border(halfedge) || !is_wanted(halfedge))) return false;
  const Corners at = corners(halfedge);
  if (!flip(halfedge)) return false;
  note_change(at);
  push_around(halfedge);
  return true;
}

// Each flip decreases a bounded measure, so flips end. Because of rounding, their number is limited
// as well.
FlipCounts Flipper::run(const Progress& progress) {
  progress("flip");
  count_valences();
  look_ahead();
  FlipCounts counts;
  std::size_t edges = 0;
  while (swept_ < states_.size()) {
    const State state = states_[swept_++];
    const bool is_edge = (state & edge) != 0, may_flip = (state & (wanted_before | changed)) != 0;
    edges += is_edge ? 1 : 0;
    if (is_edge & may_flip) counts.done += visit(swept_ - 1) ? 1 : 0;
  }
  for (std::size_t next = 0; next < queue_.size() && next < 19 * edges; ++next) {
    if (next % 16384 == 0)
      progress("flip", static_cast<double>(next + 1) / static_cast<double>(next + edges));
    counts.done += visit(queue_[next]) ? 1 : 0;
  }
  counts.refused = refused_;
  return counts;
}

}  // namespace

FlipCounts flip_edges(EditableMesh& mesh, EmbeddingGuard& guard, FlipRule rule,
                      const EdgeLimits& limits, const Progress& progress) {
  if (rule == FlipRule::none) return {};
  return Flipper(mesh, guard, rule, limits).run(progress);
}

bool flip_edge(EditableMesh& mesh, EmbeddingGuard& guard, Index halfedge,
               const EdgeLimits& limits) {
  return Flipper(mesh, guard, FlipRule::angle, limits).flip(halfedge);
}

}  // namespace transformesh

#include "remesh/operations/split.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "mesh/coordinate_spacing.h"
#include "remesh/halfedges/select_slots.h"
#include "remesh/operations/edge_queue.h"
#include "remesh/operations/exact_split.h"
#include "remesh/operations/vertex_mover.h"

namespace transformesh {
namespace {

/// A midpoint that touches other faces is moved along its normal by these distances, in spacings of
/// its largest coordinate.
constexpr std::array<double, 3> roundings{1, 2, 4};
constexpr int most_contact_rounds = 4;  ///< largest number of rounds; chosen by hand, not measured
/// Edges shorter than this many spacings are not split. Rounding moves midpoints by up to half the
/// square root of 3 spacings. If the edge is longer, all edges to its midpoint are shorter than the
/// edge itself; otherwise splits might not end.
constexpr double least_spacings = 8;

double rounding_at(const EditableMesh& mesh, const Vec3& point) {
  return spacing_around(point, mesh.coordinate());
}

class Splitter {
 public:
  Splitter(EditableMesh& mesh, const SplitLimits& limits, ExactSplitter* exact)
      : mesh_(mesh),
        limit_(limits.longest * limits.longest),
        keep_border_(limits.keep_border),
        first_left_(limits.only_given ? mesh.vertex_slots() : no_index),
        exact_(exact) {}

  SplitCounts run(const Progress& progress) {
    push_all();
    const auto first = static_cast<double>(queue_.size());
    for (double tried = 0; !queue_.empty(); ++tried) {
      if (std::fmod(tried, 4096) == 0) progress("split", tried / (tried + first));
      const QueuedEdge edge = queue_.top();
      queue_.pop();
      if (!edge.is_current(mesh_)) continue;
      if (!is_held_.empty() && is_beside_held(edge)) {
        hold(edge.halfedge, true);
      } else {
        split(edge.halfedge);
      }
    }
    return counts_;
  }

 private:
  void push_all() {
    const auto is_wanted = [&](double squared) { return keep_border_ || squared > limit_; };
    for (const Index h : edges_where(mesh_, is_wanted)) push(h);
  }

  void push(Index halfedge) {
    const bool is_kept = keep_border_ && mesh_.is_border(halfedge);
    if (keep_border_ || !is_held_.empty()) hold(halfedge, is_kept);
    if (std::max(mesh_.source(halfedge), mesh_.target(halfedge)) >= first_left_) return;
    if (mesh_.scaled_squared_length(halfedge) <= limit_ || is_kept || is_short(halfedge)) return;
    queue_.emplace(mesh_, halfedge);
  }

  bool is_short(Index halfedge) const {
    const Vec3& source = mesh_.position(mesh_.source(halfedge));
    const Vec3& target = mesh_.position(mesh_.target(halfedge));
    const Vec3 largest = source.cwiseAbs().cwiseMax(target.cwiseAbs());
    return (target - source).norm() < least_spacings * rounding_at(mesh_, largest);
  }

  void hold(Index halfedge, bool is_held) {
    is_held_.resize(mesh_.halfedge_slots());
    is_held_[halfedge] = is_held;
    if (!mesh_.is_border(halfedge)) is_held_[mesh_.opposite(halfedge)] = is_held;
  }

  /// True if a face at the edge has a longer edge that cannot be split (is held) and is longer than
  /// 1.5 times the limit. Splitting the other edges of such a face would never make all of them
  /// short: their lengths approach one third and two thirds of the held edge. Longer edges are
  /// always decided earlier.
  bool is_beside_held(const QueuedEdge& edge) const {
    const auto holds = [&](Index other) {
      const double length = mesh_.scaled_squared_length(other);
      return other < is_held_.size() && is_held_[other] && length > 2.25 * limit_ &&
             length > edge.squared_length;
    };
    const auto is_held_in_face = [&](Index side) {
      return holds(next_halfedge(side)) || holds(previous_halfedge(side));
    };
    return is_held_in_face(edge.halfedge) ||
           (!mesh_.is_border(edge.halfedge) && is_held_in_face(mesh_.opposite(edge.halfedge)));
  }

  void split(Index halfedge) {
    if (exact_ != nullptr) return split_exactly(halfedge);
    const Vec3& source = mesh_.position(mesh_.source(halfedge));
    const Vec3& target = mesh_.position(mesh_.target(halfedge));
    const Vec3 middle = mesh_.rounded(0.5 * source + 0.5 * target);
    if (middle == source || middle == target) return;
    counts_.ends.push_back({mesh_.source(halfedge), mesh_.target(halfedge)});
    counts_.parents.push_back(halfedge / 3);
    if (!mesh_.is_border(halfedge)) counts_.parents.push_back(mesh_.opposite(halfedge) / 3);
    push_around(mesh_.split(halfedge, middle));
  }

  void split_exactly(Index halfedge) {
    const std::vector<Index> vertices = exact_->split(halfedge, keep_border_);
    std::for_each(vertices.begin(), vertices.end(), [&](Index vertex) { push_around(vertex); });
    if (!vertices.empty()) return;
    hold(halfedge, true);
    ++counts_.refused;
  }

  /// Enqueues the edges at a new vertex, which may be too long. Also enqueues the edges around it,
  /// whose halfedges may have new indices.
  void push_around(Index vertex) {
    ++counts_.done;
    mesh_.for_each_outgoing(vertex, [&](Index outgoing) {
      push(outgoing);
      push(next_halfedge(outgoing));
      if (mesh_.is_border(previous_halfedge(outgoing))) push(previous_halfedge(outgoing));
    });
  }

  EditableMesh& mesh_;
  double limit_;
  bool keep_border_;
  Index first_left_;  ///< edges with an end at this vertex or a later one are not split
  ExactSplitter* exact_;
  EdgeQueue<LongerFirst> queue_;
  /// True for each halfedge whose edge cannot be split; empty while all edges may be split.
  std::vector<bool> is_held_;
  SplitCounts counts_;
};

bool settle(EditableMesh& mesh, VertexMover& mover, Index vertex, VertexStar& star) {
  star.gather(mesh, vertex);
  const Vec3 center = star.center();
  if (mover.move(vertex, star, center)) return true;
  const Vec3 step = rounding_at(mesh, center) * star.normal().normalized();
  for (const double distance : roundings) {
    if (mover.move(vertex, star, center + distance * step)) return true;
    if (mover.move(vertex, star, center - distance * step)) return true;
  }
  return false;
}

}  // namespace

SplitCounts split_long_edges(EditableMesh& mesh, const SplitLimits& limits,
                             const Progress& progress) {
  return Splitter(mesh, limits, nullptr).run(progress);
}

SplitCounts split_long_edges_exactly(EditableMesh& mesh, const SplitLimits& limits,
                                     const Progress& progress) {
  ExactGuard guard(mesh);
  ExactSplitter exact(mesh, guard);
  return Splitter(mesh, limits, &exact).run(progress);
}

std::vector<Index> settle_midpoints(EditableMesh& mesh, EmbeddingGuard& guard, Index first) {
  VertexMover mover(mesh, guard);
  VertexStar star;
  std::vector<Index> in_contact;
  const auto try_to_settle = [&](Index vertex) {
    if (!settle(mesh, mover, vertex, star)) in_contact.push_back(vertex);
  };
  for (Index v = first; v < mesh.vertex_slots(); ++v) try_to_settle(v);

  // Tries again, because neighbors may have moved out of contact.
  for (int round = 0; round < most_contact_rounds && !in_contact.empty(); ++round) {
    const std::vector<Index> again = std::exchange(in_contact, {});
    std::for_each(again.begin(), again.end(), try_to_settle);
    if (in_contact.size() == again.size()) break;
  }
  return in_contact;
}

}  // namespace transformesh

#include "tm/remesh/operations/split.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tm/remesh/halfedges/where.h"
#include "tm/remesh/operations/edge_queue.h"
#include "tm/remesh/operations/vertex_mover.h"

namespace transformesh {
namespace {

/// A midpoint in contact is tried at these distances, in spacings of its largest coordinate.
constexpr std::array<double, 3> roundings{1, 2, 4};
constexpr int most_rounds = 4;
/// Shorter edges, in the same spacings, are not split: their midpoints are rounded by up to a half
/// of the square root of 3, and with at least so many, lines to the midpoint of a longest edge are
/// shorter than it all the same. Else splits would never end.
constexpr double least_spacings = 8;

/// From the largest coordinate to the next number of the mesh's type.
double rounding_at(const EditableMesh& mesh, const Vec3& point) {
  const double largest = point.cwiseAbs().maxCoeff();
  const double next = mesh.is_single() ? std::nextafter(static_cast<float>(largest), HUGE_VALF)
                                       : std::nextafter(largest, HUGE_VAL);
  return next - largest;
}

class Splitter {
 public:
  Splitter(EditableMesh& mesh, double max_edge, bool keep_border)
      : mesh_(mesh), limit_(max_edge * max_edge), keep_border_(keep_border) {}

  std::size_t run(const Progress& progress) {
    push_all();
    const auto first = static_cast<double>(queue_.size());
    for (double tried = 0; !queue_.empty(); ++tried) {
      if (std::fmod(tried, 4096) == 0) progress("split", tried / (tried + first));
      const QueuedEdge edge = queue_.top();
      queue_.pop();
      if (!edge.is_current(mesh_)) continue;
      if (keep_border_ && is_beside_held(edge)) {
        hold(edge.halfedge, true);
      } else {
        split(edge.halfedge);
      }
    }
    return splits_;
  }

 private:
  void push_all() {
    const auto is_wanted = [&](double squared) { return keep_border_ || squared > limit_; };
    for (const Index h : edges_where(mesh_, is_wanted)) push(h);
  }

  void push(Index halfedge) {
    const bool is_kept = keep_border_ && mesh_.is_border(halfedge);
    if (keep_border_) hold(halfedge, is_kept);
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

  /// Whether a longer edge of its faces stays as it is, a border or itself beside one that stays,
  /// and is longer than 1.5 times the limit. The two others of a face, halved in turn, come to a
  /// third and two thirds of it, and so splits would never end. Longer edges came first.
  bool is_beside_held(const QueuedEdge& edge) const {
    const auto holds = [&](Index other) {
      const double length = mesh_.scaled_squared_length(other);
      return is_held_[other] && length > 2.25 * limit_ && length > edge.squared_length;
    };
    const auto is_held_in_face = [&](Index side) {
      return holds(next_halfedge(side)) || holds(previous_halfedge(side));
    };
    return is_held_in_face(edge.halfedge) ||
           (!mesh_.is_border(edge.halfedge) && is_held_in_face(mesh_.opposite(edge.halfedge)));
  }

  void split(Index halfedge) {
    const Vec3& source = mesh_.position(mesh_.source(halfedge));
    const Vec3& target = mesh_.position(mesh_.target(halfedge));
    const Vec3 middle = mesh_.rounded(0.5 * source + 0.5 * target);
    if (middle == source || middle == target) return;
    const Index vertex = mesh_.split(halfedge, middle);
    ++splits_;

    // Edges at the new vertex may be too long, and some of those around it have a new name.
    mesh_.for_each_outgoing(vertex, [&](Index outgoing) {
      push(outgoing);
      push(next_halfedge(outgoing));
      if (mesh_.is_border(previous_halfedge(outgoing))) push(previous_halfedge(outgoing));
    });
  }

  EditableMesh& mesh_;
  double limit_;
  bool keep_border_;
  EdgeQueue<LongerFirst> queue_;
  std::vector<bool> is_held_;  ///< per halfedge
  std::size_t splits_ = 0;
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

std::size_t split_long_edges(EditableMesh& mesh, double max_edge, bool keep_border,
                             const Progress& progress) {
  return Splitter(mesh, max_edge, keep_border).run(progress);
}

std::size_t settle_midpoints(EditableMesh& mesh, EmbeddingGuard& guard, Index first) {
  VertexMover mover(mesh, guard);
  VertexStar star;
  std::vector<Index> in_contact;
  const auto try_to_settle = [&](Index vertex) {
    if (!settle(mesh, mover, vertex, star)) in_contact.push_back(vertex);
  };
  for (Index v = first; v < mesh.vertex_slots(); ++v) try_to_settle(v);

  // Neighbors may be out of the way by now.
  for (int round = 0; round < most_rounds && !in_contact.empty(); ++round) {
    const std::vector<Index> again = std::exchange(in_contact, {});
    std::for_each(again.begin(), again.end(), try_to_settle);
    if (in_contact.size() == again.size()) break;
  }
  return in_contact.size();
}

}  // namespace transformesh

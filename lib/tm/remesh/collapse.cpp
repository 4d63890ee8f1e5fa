#include "tm/remesh/collapse.h"

#include <algorithm>
#include <cmath>

#include "tm/remesh/edge_queue.h"
#include "tm/remesh/star.h"

namespace transformesh {
namespace {

constexpr double least_turn_cosine = 0.5;
/// Triangles at least this round are good enough; others must not get worse.
constexpr double round_enough = 0.3;
/// Edges up to this many times the shortest may go where that makes valences regular.
constexpr double longest_irregular = 1.15;
/// A triangle rounder than this has a normal to rely on.
constexpr double normal_roundness = 0.02;

class Collapser {
 public:
  Collapser(EditableMesh& mesh, EmbeddingGuard& guard, const VertexRoles& roles, double max_edge)
      : mesh_(mesh), guard_(guard), roles_(roles), longest_(max_edge * max_edge) {}

  /// The vertex that the edge became, or no_index.
  Index collapse(Index halfedge);

 private:
  /// One triangle that stays, with its corner at the edge left out.
  struct Spoke {
    Vec3 first;
    Vec3 second;
    Vec3 normal;
    bool has_normal;
    double first_limit;  ///< squared: no new edge to `first` may be longer
    double second_limit;
  };

  void gather();
  void gather_star(Index vertex);
  double longest_to(Index neighbour) const;
  bool try_position(const Vec3& wanted, double source_share);
  bool try_free_positions();
  Vec3 volume_keeping_shift(const Vec3& position) const;
  bool is_sound(const Vec3& position) const;
  double least_roundness_before() const;
  void fill_patch(const Vec3& position);

  EditableMesh& mesh_;
  EmbeddingGuard& guard_;
  const VertexRoles& roles_;
  double longest_;
  Index edge_ = no_index;
  Index goes_ = no_index;
  Index stays_ = no_index;
  std::vector<Spoke> spokes_;
  Vec3 mean_normal_ = Vec3::Zero();
  double volume_ = 0;  ///< six times what the star of goes_ encloses with stays_
  Patch patch_;
};

Index Collapser::collapse(Index halfedge) {
  if (!roles_.may_merge(halfedge) || !mesh_.can_collapse(halfedge)) return no_index;
  const bool turned = !mesh_.is_border(halfedge) && mesh_.target(halfedge) > mesh_.source(halfedge);
  edge_ = turned ? mesh_.opposite(halfedge) : halfedge;
  goes_ = mesh_.source(edge_);
  stays_ = mesh_.target(edge_);
  gather();

  // the end that is bound more keeps its place
  const VertexRole from = roles_[goes_];
  const VertexRole to = roles_[stays_];
  bool done = false;
  if (from != to) {
    const bool source_wins = from > to;
    done = try_position(mesh_.position(source_wins ? goes_ : stays_), source_wins ? 1 : 0);
  } else {
    done = try_free_positions();
  }
  return done ? stays_ : no_index;
}

void Collapser::gather() {
  spokes_.clear();
  patch_.clear();
  mean_normal_.setZero();
  volume_ = 0;
  gather_star(goes_);
  gather_star(stays_);
  patch_.vertices.push_back(stays_);
}

void Collapser::gather_star(Index vertex) {
  const Vec3& corner = mesh_.position(vertex);
  const Vec3& origin = mesh_.position(stays_);
  mesh_.for_each_outgoing(vertex, [&](Index halfedge) {
    const Index first = mesh_.target(halfedge);
    const Index second = mesh_.apex(halfedge);
    const Vec3& a = mesh_.position(first);
    const Vec3& b = mesh_.position(second);
    patch_.replaced.push_back(halfedge / 3);
    const Index other_end = vertex == goes_ ? stays_ : goes_;
    if (first == other_end || second == other_end) return;
    const Vec3 normal = normal_of(corner, a, b);
    const double to_a = (a - corner).squaredNorm();
    const double to_b = (b - corner).squaredNorm();
    const double longest = std::max(to_a, to_b);
    const double needed = normal_roundness * (to_a + to_b + (b - a).squaredNorm());
    spokes_.push_back({a, b, normal, 12 * normal.squaredNorm() > needed * needed,
                       std::max(longest, longest_to(first)),
                       std::max(longest, longest_to(second))});
    mean_normal_ += normal;
    volume_ += (corner - origin).dot((a - origin).cross(b - origin));
    patch_.vertices.push_back(first);
    patch_.vertices.push_back(second);
  });
}

/// Squared; the merged vertex counts with the mean size of both ends.
double Collapser::longest_to(Index neighbour) const {
  const double size = 0.5 * (mesh_.mean_size(goes_, stays_) + mesh_.size(neighbour));
  return longest_ * size * size;
}

bool Collapser::try_free_positions() {
  const Vec3& source = mesh_.position(goes_);
  const Vec3& target = mesh_.position(stays_);
  const Vec3 middle = 0.5 * source + 0.5 * target;
  if (roles_[stays_] == VertexRole::free) {
    const Vec3 shift = volume_keeping_shift(middle);
    if (shift.norm() <= 0.5 * (target - source).norm() && try_position(middle + shift, 0.5)) {
      return true;
    }
  }
  return try_position(middle, 0.5) || try_position(target, 0) || try_position(source, 1);
}

Vec3 Collapser::volume_keeping_shift(const Vec3& position) const {
  // the volume is linear in the position: six times it is position . ring + const
  const Vec3& origin = mesh_.position(stays_);
  Vec3 ring = Vec3::Zero();
  for (const Spoke& spoke : spokes_) {
    ring += (spoke.first - origin).cross(spoke.second - origin);
  }
  const double squared = ring.squaredNorm();
  if (squared == 0) return Vec3::Zero();
  return (volume_ - (position - origin).dot(ring)) / squared * ring;
}

bool Collapser::is_sound(const Vec3& position) const {
  double least = 1;
  for (const Spoke& spoke : spokes_) {
    if ((spoke.first - position).squaredNorm() > spoke.first_limit) return false;
    if ((spoke.second - position).squaredNorm() > spoke.second_limit) return false;
    const Vec3& before = spoke.has_normal ? spoke.normal : mean_normal_;
    const Vec3 after = normal_of(position, spoke.first, spoke.second);
    if (turns(before, after, least_turn_cosine)) return false;
    least = std::min(least, roundness(position, spoke.first, spoke.second));
  }
  return least >= round_enough || least >= least_roundness_before();
}

/// Of the triangles at both ends.
double Collapser::least_roundness_before() const {
  double least = 1;
  for (const Index face : patch_.replaced) {
    least = std::min(least, roundness(mesh_.position(mesh_.source(3 * face)),
                                      mesh_.position(mesh_.source(3 * face + 1)),
                                      mesh_.position(mesh_.source(3 * face + 2))));
  }
  return least;
}

void Collapser::fill_patch(const Vec3& position) {
  patch_.centre = stays_;
  patch_.centre_position = position;
  patch_.made.clear();
  patch_.normals.clear();
  patch_.longest_squared = 0;
  for (const Spoke& spoke : spokes_) {
    patch_.longest_squared =
        std::max({patch_.longest_squared, (spoke.first - position).squaredNorm(),
                  (spoke.second - position).squaredNorm()});
    patch_.made.push_back({position, spoke.first, spoke.second});
    patch_.normals.push_back(normal_of(position, spoke.first, spoke.second));
  }
}

bool Collapser::try_position(const Vec3& wanted, double source_share) {
  const Vec3 position = mesh_.rounded(wanted);
  if (!is_sound(position)) return false;
  fill_patch(position);
  if (!guard_.allows(patch_)) return false;
  mesh_.collapse(edge_, position, source_share);
  guard_.forget(goes_);
  guard_.commit(patch_);
  return true;
}

/// Edges that are to go, the shortest first.
template <class Wanted>
class Candidates {
 public:
  Candidates(const EditableMesh& mesh, const Wanted& wanted) : mesh_(mesh), wanted_(wanted) {
    for (Index h = 0; h < mesh.halfedge_slots(); ++h) {
      if (mesh.is_edge(h)) push(h);
    }
  }

  bool empty() const { return queue_.empty(); }
  std::size_t size() const { return queue_.size(); }
  QueuedEdge pop() {
    const QueuedEdge edge = queue_.top();
    queue_.pop();
    return edge;
  }
  void push_around(Index vertex) {
    mesh_.for_each_neighbour(vertex, [&](Index, Index halfedge) { push(halfedge); });
  }

 private:
  void push(Index halfedge) {
    if (wanted_(halfedge)) queue_.emplace(mesh_, halfedge);
  }

  const EditableMesh& mesh_;
  const Wanted& wanted_;
  EdgeQueue<ShorterFirst> queue_;
};

template <class Wanted>
CollapseCounts collapse_wanted(EditableMesh& mesh, Collapser& collapser, Wanted& wanted,
                               const Progress& progress) {
  CollapseCounts counts;
  Candidates<Wanted> edges(mesh, wanted);
  const double first = static_cast<double>(edges.size());
  for (double tried = 0; !edges.empty(); ++tried) {
    if (std::fmod(tried, 1024) == 0) progress("collapse", tried / (tried + first));
    const QueuedEdge edge = edges.pop();
    if (!edge.is_current(mesh) || !wanted(edge.halfedge)) continue;
    const Index vertex = collapser.collapse(edge.halfedge);
    if (vertex == no_index) {
      ++counts.refused;
    } else {
      ++counts.done;
      wanted.note_merged(vertex);
      edges.push_around(vertex);
    }
  }
  return counts;
}

class IsShort {
 public:
  IsShort(const EditableMesh& mesh, double min_edge, bool keep_border)
      : mesh_(mesh), limit_(min_edge * min_edge), keep_border_(keep_border) {}
  bool operator()(Index halfedge) const {
    return mesh_.scaled_squared_length(halfedge) < limit_ &&
           !(keep_border_ && mesh_.is_border(halfedge));
  }
  void note_merged(Index) const {}

 private:
  const EditableMesh& mesh_;
  double limit_;
  bool keep_border_;
};

/// Edges not too long whose collapse brings valences closer to six.
class IsIrregular {
 public:
  IsIrregular(const EditableMesh& mesh, double longest)
      : mesh_(mesh), limit_(longest * longest), excess_(mesh.vertex_slots(), -6) {
    for (Index h = 0; h < mesh.halfedge_slots(); ++h) {
      if (!mesh.has_halfedge(h)) continue;
      ++excess_[mesh.source(h)];
      if (mesh.is_border(h)) ++excess_[mesh.target(h)];  // which has one edge more than faces
    }
  }
  bool operator()(Index halfedge) const {
    return mesh_.scaled_squared_length(halfedge) < limit_ && !mesh_.is_border(halfedge) &&
           gain(halfedge) > 0;
  }
  void note_merged(Index vertex) {
    recount(vertex);
    mesh_.for_each_neighbour(vertex, [&](Index neighbour, Index) { recount(neighbour); });
  }

 private:
  void recount(Index vertex) { excess_[vertex] = static_cast<int>(mesh_.valence(vertex)) - 6; }
  /// By how much the squared deviations from six shrink.
  int gain(Index halfedge) const {
    const int source = excess_[mesh_.source(halfedge)];
    const int target = excess_[mesh_.target(halfedge)];
    const int left = excess_[mesh_.apex(halfedge)];
    const int right = excess_[mesh_.apex(mesh_.opposite(halfedge))];
    const int merged = source + target + 2;
    // each apex loses an edge: x^2 - (x - 1)^2 = 2x - 1
    return source * source + target * target - merged * merged + 2 * left + 2 * right - 2;
  }

  const EditableMesh& mesh_;
  double limit_;
  std::vector<int> excess_;  ///< valence minus six
};

}  // namespace

CollapseCounts collapse_short_edges(EditableMesh& mesh, EmbeddingGuard& guard,
                                    const VertexRoles& roles, const EdgeLimits& limits,
                                    const Progress& progress) {
  Collapser collapser(mesh, guard, roles, limits.longest);
  IsShort is_short(mesh, limits.shortest, roles.keeps_border());
  CollapseCounts counts = collapse_wanted(mesh, collapser, is_short, progress);
  if (counts.refused == 0) return counts;

  // an edge may be refused more than once, or be gone in the end
  counts.refused = 0;
  for (Index h = 0; h < mesh.halfedge_slots(); ++h) {
    counts.refused += mesh.is_edge(h) && is_short(h) ? 1 : 0;
  }
  return counts;
}

std::size_t collapse_for_valence(EditableMesh& mesh, EmbeddingGuard& guard,
                                 const VertexRoles& roles, const EdgeLimits& limits,
                                 const Progress& progress) {
  Collapser collapser(mesh, guard, roles, limits.stretched());
  IsIrregular is_irregular(mesh, longest_irregular * limits.shortest);
  return collapse_wanted(mesh, collapser, is_irregular, progress).done;
}

bool collapse_edge(EditableMesh& mesh, EmbeddingGuard& guard, const VertexRoles& roles,
                   Index halfedge, double max_edge) {
  return Collapser(mesh, guard, roles, max_edge).collapse(halfedge) != no_index;
}

}  // namespace transformesh

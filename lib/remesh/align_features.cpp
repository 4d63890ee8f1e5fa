#include "transformesh/align_features.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include "geometry/search/closest_point.h"
#include "geometry/search/kd_tree.h"
#include "mesh/coordinate_spacing.h"
#include "mesh/edges.h"
#include "mesh/surface_columns.h"
#include "remesh/guards/edge_rules.h"
#include "remesh/halfedges/triangle_quality.h"
#include "remesh/operations/collapse.h"
#include "remesh/operations/exact_split.h"
#include "remesh/operations/flip.h"
#include "remesh/operations/safe_split.h"
#include "remesh/operations/smooth.h"
#include "remesh/operations/split.h"
#include "remesh/operations/vertex_mover.h"
#include "support/elementary/trigonometric.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// Number of rounds that move vertices onto the corners and lines (chains of sharp edges) of the
/// target. The first round works on the unchanged mesh; later rounds alternate with remeshing and
/// relaxation. With more rounds, more vertices are aligned in more time.
constexpr int snap_rounds = 3;
constexpr int relax_rounds = 3;
/// The largest distance that a vertex moves to a corner and to a line of the target, as a multiple
/// of the mean length of its edges. Larger values reach more lines and distort more triangles.
constexpr double corner_reach = 1.2;
constexpr double line_reach = 0.8;
/// Largest length of an edge after a movement, as a multiple of AlignOptions::max_edge.
constexpr double longest_allowed = 1.6;
/// A movement is allowed if all its triangles have at least this roundness (triangle_quality.h), or
/// if none becomes less round.
constexpr double round_enough = 0.25;
/// An edge runs along a line of the target if the distance of its middle from the line is at most
/// this share of its length.
constexpr double along = 0.1;
/// A flip is refused if a new triangle has at most this roundness.
constexpr double sliver = 0.15;
/// Number of nearest vertices that are tried in turn for each corner.
constexpr std::size_t corner_tries = 4;
/// A vertex is on a line of the target if its distance from the line is at most this share of its
/// mean edge.
constexpr double contact = 1e-9;
/// A flip must bring the middle of the edge nearer to the target by more than this share of its
/// length, so that no edge flips back and forth.
constexpr double nearer = 0.02;
/// A vertex of the target where a line (a chain of sharp edges) turns by more than 45 degrees is a
/// corner.
constexpr double corner_cosine = 0.7071067811865476;
/// A mesh has features if edges of more than this angle have more than this share of the length of
/// all edges. A larger share would miss meshes with few sharp edges; a smaller one would take noise
/// for features.
constexpr double certain_angle_deg = 60;
constexpr double certain_share = 0.02;

/// Value of `is_held_` for a vertex on a corner of the target. The value is 1 for a vertex on a
/// line (a chain of sharp edges), and 0 for any other vertex.
constexpr char on_corner = 2;

double cosine_of(double angle_deg) { return elementary::cos(angle_deg * std::numbers::pi / 180); }

/// Calls visit(halfedge) for one halfedge of each edge between two faces whose normals enclose an
/// angle with a cosine below `cosine`.
template <class Visit>
void for_each_sharp_edge(const Mesh& mesh, double cosine, const Visit& visit) {
  const Edges edges(mesh);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto halfedges = edges.halfedges(e);
    if (halfedges.size() != 2) continue;
    const Vec3 here = face_normal(mesh, halfedges[0] / 3).stableNormalized();
    const Vec3 there = face_normal(mesh, halfedges[1] / 3).stableNormalized();
    if (here.isZero(0) || there.isZero(0)) continue;
    if (here.dot(there) < cosine) visit(halfedges[0]);
  }
}

/// The lines (chains of sharp edges) of a target, and their corners: the vertices where lines end,
/// turn or meet.
class SharpLines {
 public:
  SharpLines(const Mesh& target, double cosine) {
    std::vector<std::vector<Index>> neighbors(target.positions.size());
    segments_.positions = target.positions;
    for_each_sharp_edge(target, cosine, [&](Index halfedge) {
      const Index from = halfedge_source(target, halfedge);
      const Index to = halfedge_target(target, halfedge);
      neighbors[from].push_back(to);
      neighbors[to].push_back(from);
      segments_.faces.push_back({from, to, to});
    });
    for (Index v = 0; v < neighbors.size(); ++v)
      if (is_corner(target, v, neighbors[v])) corners_.push_back(target.positions[v]);
    if (!segments_.faces.empty()) closest_.emplace(segments_);
  }
  SharpLines(const SharpLines&) = delete;
  SharpLines& operator=(const SharpLines&) = delete;

  std::size_t edges() const { return segments_.faces.size(); }
  const std::vector<Vec3>& corners() const { return corners_; }
  Vec3 nearest(const Vec3& point) const { return closest_->nearby(point, 0); }

 private:
  static bool is_corner(const Mesh& target, Index v, const std::vector<Index>& neighbors) {
    if (neighbors.empty()) return false;
    if (neighbors.size() != 2) return true;
    const Vec3 in = target.positions[v] - target.positions[neighbors[0]];
    const Vec3 out = target.positions[neighbors[1]] - target.positions[v];
    return in.dot(out) < corner_cosine * in.norm() * out.norm();
  }

  Mesh segments_;  ///< each sharp edge as a triangle without area, for ClosestPointQuery
  std::vector<Vec3> corners_;
  std::optional<ClosestPointQuery> closest_;
};

class Aligner {
 public:
  Aligner(EditableMesh& mesh, const SharpLines& lines, const Mesh& target,
          const ClosestPointQuery& surface, const AlignOptions& options, const Progress& progress)
      : mesh_(mesh),
        lines_(lines),
        target_(target),
        surface_(surface),
        options_(options),
        cosine_(cosine_of(options.feature_angle_deg)),
        progress_(progress),
        is_held_(mesh.vertex_slots(), 0) {}

  void run();
  std::size_t aligned() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(is_held_, [](char held) { return held != 0; }));
  }

 private:
  struct Candidate {
    /// Distance of the vertex from the nearest line of the target, in mean lengths of its edges.
    double distance;
    Index vertex;
    bool operator<(const Candidate& other) const {
      return distance != other.distance ? distance < other.distance : vertex < other.vertex;
    }
  };

  void hold_what_is_on_lines();
  void snap_to_corners(EmbeddingGuard& guard);
  void snap_to_lines(EmbeddingGuard& guard);
  void flip_towards_target(EmbeddingGuard& guard);
  void snap(bool splits);
  void mark_aligned_edges();
  void tidy(bool moves);
  void slide_back(EmbeddingGuard& guard, const VertexRoles& roles);
  bool move(VertexMover& mover, Index vertex, const Vec3& goal);
  void split_what_crosses();
  void find_sides();
  bool crosses_line(Index first, Index second) const;
  bool crosses_line(Index vertex) const;
  double mean_edge(Index vertex) const;
  double roundness_after_flip(Index halfedge) const;
  double middle_distance(Index first, Index second) const;

  EditableMesh& mesh_;
  const SharpLines& lines_;
  const Mesh& target_;
  const ClosestPointQuery& surface_;
  const AlignOptions& options_;
  const EdgeLimits limits_{options_.min_edge, options_.max_edge};
  double cosine_;
  const Progress& progress_;
  /// For each vertex: 1 if it is on a line of the target, `on_corner` on a corner, otherwise 0.
  std::vector<char> is_held_;
  std::vector<Vec3> sides_;  ///< for each vertex the normal of the nearest face of the target
  VertexStar star_;
};

double Aligner::mean_edge(Index vertex) const {
  double sum = 0;
  double count = 0;
  mesh_.for_each_neighbor(vertex, [&](Index neighbor, Index) {
    sum += (mesh_.position(neighbor) - mesh_.position(vertex)).norm();
    ++count;
  });
  return sum / count;
}

void Aligner::hold_what_is_on_lines() {
  is_held_.assign(mesh_.vertex_slots(), 0);
  for (Index v = 0; v < mesh_.vertex_slots(); ++v) {
    if (!mesh_.has_vertex(v)) continue;
    const double distance = (lines_.nearest(mesh_.position(v)) - mesh_.position(v)).norm();
    const double spacing = spacing_around(mesh_.position(v), options_.coordinate);
    is_held_[v] = distance <= contact * mean_edge(v) + 2 * spacing ? 1 : 0;
  }
}

// Moves the vertex towards the goal. Returns true if the vertex reached the goal.
bool Aligner::move(VertexMover& mover, Index vertex, const Vec3& goal) {
  const Vec3 target = mesh_.rounded(goal);
  if (mesh_.position(vertex) == target) return true;
  star_.gather(mesh_, vertex);
  return mover.move(vertex, star_, target) && mesh_.position(vertex) == target;
}

void Aligner::snap_to_corners(EmbeddingGuard& guard) {
  VertexMover mover(mesh_, guard, round_enough);
  std::vector<Vec3> positions;
  std::vector<Index> vertices;
  for (Index v = 0; v < mesh_.vertex_slots(); ++v) {
    if (!mesh_.has_vertex(v)) continue;
    positions.push_back(mesh_.position(v));
    vertices.push_back(v);
  }
  const KdTree tree(positions);
  for (const Vec3& corner : lines_.corners())
    for (const Index nearest : tree.nearest(corner, corner_tries)) {
      const Index vertex = vertices[nearest];
      if (is_held_[vertex] == on_corner && mesh_.position(vertex) != mesh_.rounded(corner))
        continue;
      const double distance = (mesh_.position(vertex) - corner).norm();
      if (distance > corner_reach * mean_edge(vertex) || !move(mover, vertex, corner)) continue;
      is_held_[vertex] = on_corner;
      break;
    }
}

void Aligner::find_sides() {
  sides_.assign(mesh_.vertex_slots(), Vec3::Zero());
  for (Index v = 0; v < mesh_.vertex_slots(); ++v)
    if (mesh_.has_vertex(v))
      sides_[v] = face_normal(target_, surface_(mesh_.position(v)).face).stableNormalized();
}

/// True if the ends of the edge are on different sides of a line of the target that passes near its
/// middle.
bool Aligner::crosses_line(Index first, Index second) const {
  if (is_held_[first] != 0 || is_held_[second] != 0) return false;
  if (!(sides_[first].dot(sides_[second]) < cosine_)) return false;
  const Vec3 middle = 0.5 * mesh_.position(first) + 0.5 * mesh_.position(second);
  const double length = (mesh_.position(first) - mesh_.position(second)).norm();
  return (lines_.nearest(middle) - middle).norm() < length;
}

bool Aligner::crosses_line(Index vertex) const {
  bool crosses = false;
  mesh_.for_each_neighbor(
      vertex, [&](Index neighbor, Index) { crosses = crosses || crosses_line(vertex, neighbor); });
  return crosses;
}

// Splits edges that still cross a line of the target, because neither of their ends could be moved
// onto it.
void Aligner::split_what_crosses() {
  find_sides();
  ExactGuard guard(mesh_);
  ExactSplitter splitter(mesh_, guard);
  const Index edges = mesh_.halfedge_slots();
  for (Index h = 0; h < edges; ++h) {
    if (!mesh_.is_edge(h) || mesh_.is_border(h)) continue;
    const Index from = mesh_.source(h);
    const Index to = mesh_.target(h);
    if (from >= sides_.size() || to >= sides_.size() || !crosses_line(from, to)) continue;
    splitter.split(h, false);
    is_held_.resize(mesh_.vertex_slots(), 0);
  }
}

void Aligner::snap_to_lines(EmbeddingGuard& guard) {
  std::vector<Candidate> candidates;
  find_sides();
  for (Index v = 0; v < mesh_.vertex_slots(); ++v) {
    if (!mesh_.has_vertex(v)) continue;
    const Vec3& position = mesh_.position(v);
    const double distance = (lines_.nearest(position) - position).norm() / mean_edge(v);
    if (is_held_[v] == 0 && distance < line_reach) candidates.push_back({distance, v});
  }
  std::sort(candidates.begin(), candidates.end());
  VertexMover mover(mesh_, guard, round_enough);
  for (const Candidate& candidate : candidates) {
    const Index v = candidate.vertex;
    if (!crosses_line(v)) continue;
    is_held_[v] = move(mover, v, lines_.nearest(mesh_.position(v))) ? 1 : 0;
  }
}

double Aligner::middle_distance(Index first, Index second) const {
  const Vec3 middle = 0.5 * mesh_.position(first) + 0.5 * mesh_.position(second);
  return (surface_.nearby(middle, 0) - middle).norm();
}

double Aligner::roundness_after_flip(Index halfedge) const {
  const Vec3& from = mesh_.position(mesh_.source(halfedge));
  const Vec3& to = mesh_.position(mesh_.target(halfedge));
  const Vec3& left = mesh_.position(mesh_.apex(halfedge));
  const Vec3& right = mesh_.position(mesh_.apex(mesh_.opposite(halfedge)));
  return std::min(roundness(left, from, right), roundness(right, to, left));
}

void Aligner::flip_towards_target(EmbeddingGuard& guard) {
  for (Index h = 0; h < mesh_.halfedge_slots(); ++h) {
    if (!mesh_.is_edge(h) || mesh_.is_border(h)) continue;
    const Index left = mesh_.apex(h);
    const Index right = mesh_.apex(mesh_.opposite(h));
    const Index from = mesh_.source(h);
    const Index to = mesh_.target(h);
    const int held = (is_held_[left] != 0) + (is_held_[right] != 0) + (is_held_[from] != 0) +
                     (is_held_[to] != 0);
    if (held < 2) continue;
    const double length = (mesh_.position(from) - mesh_.position(to)).norm();
    const double before = middle_distance(from, to);
    if (before < nearer * length) continue;
    if (!(roundness_after_flip(h) > sliver)) continue;
    if (middle_distance(left, right) < before - nearer * length)
      flip_edge(mesh_, guard, h, {0, limits_.stretched()});
  }
}

// Marks the edges that run along a line of the target, between two vertices on that line.
void Aligner::mark_aligned_edges() {
  mesh_.clear_features();
  for (Index h = 0; h < mesh_.halfedge_slots(); ++h) {
    if (!mesh_.is_edge(h) || is_held_[mesh_.source(h)] == 0 || is_held_[mesh_.target(h)] == 0)
      continue;
    const Vec3& from = mesh_.position(mesh_.source(h));
    const Vec3& to = mesh_.position(mesh_.target(h));
    const Vec3 middle = 0.5 * from + 0.5 * to;
    if ((lines_.nearest(middle) - middle).norm() <= along * (to - from).norm())
      mesh_.set_feature(h, true);
  }
}

// Splits, collapses and flips edges for better lengths and angles; vertices on lines of the target
// stay on them. If `moves` is set, all vertices also relax within the surface, and vertices on
// lines then return to their lines.
void Aligner::tidy(bool moves) {
  mark_aligned_edges();
  const double longest = limits_.longest;
  const SafeSplitOptions splitting{
      {longest, false},
      [&] { return std::make_unique<EmbeddingGuard>(mesh_, longest_allowed * longest); }};
  const std::unique_ptr<EmbeddingGuard> owned = split_safely(mesh_, splitting, progress_).guard;
  EmbeddingGuard& guard = *owned;
  const VertexRoles roles(mesh_, false);
  collapse_short_edges(mesh_, guard, roles, limits_, progress_);
  flip_edges(mesh_, guard, FlipRule::angle, limits_, progress_);
  if (moves) {
    relax_tangentially(mesh_, guard, roles, &surface_, progress_);
    slide_back(guard, roles);
  }
  hold_what_is_on_lines();
}

void Aligner::slide_back(EmbeddingGuard& guard, const VertexRoles& roles) {
  VertexMover mover(mesh_, guard, round_enough);
  for (Index v = 0; v < mesh_.vertex_slots(); ++v) {
    if (!mesh_.has_vertex(v) || roles[v] == VertexRole::free) continue;
    const Vec3 goal = lines_.nearest(mesh_.position(v));
    if ((goal - mesh_.position(v)).norm() < line_reach * mean_edge(v)) move(mover, v, goal);
  }
}

void Aligner::snap(bool splits) {
  progress_("align");
  const Index first_new = mesh_.vertex_slots();
  if (splits) split_what_crosses();
  EmbeddingGuard guard(mesh_, longest_allowed * limits_.longest);
  settle_midpoints(mesh_, guard, first_new);
  snap_to_corners(guard);
  snap_to_lines(guard);
  flip_towards_target(guard);
}

void Aligner::run() {
  hold_what_is_on_lines();
  for (int round = 0; round < snap_rounds; ++round) snap(round > 0);
  for (int round = 0; round < relax_rounds; ++round) {
    tidy(true);
    snap(false);
  }
  tidy(false);
}

}  // namespace

bool has_features(const Mesh& target) {
  double sharp = 0;
  for_each_sharp_edge(target, cosine_of(certain_angle_deg), [&](Index halfedge) {
    sharp += (target.positions[halfedge_source(target, halfedge)] -
              target.positions[halfedge_target(target, halfedge)])
                 .norm();
  });
  const EdgeLengths all = edge_lengths(target);
  return sharp > certain_share * all.mean * static_cast<double>(all.count);
}

AlignResult align_features(Mesh& mesh, const Mesh& target, const AlignOptions& options,
                           const Progress& progress) {
  if (mesh.faces.empty()) throw InputError("the mesh has no faces, so there is nothing to align");
  if (!(options.feature_angle_deg > 0 && options.feature_angle_deg < 180))
    throw UsageError("the angle of sharp edges must be between 0 and 180 degrees");
  AlignResult result;
  const SharpLines lines(target, cosine_of(options.feature_angle_deg));
  result.sharp_edges = lines.edges();
  result.corners = lines.corners().size();
  if (lines.edges() == 0) return result;
  EditableMesh editable(mesh);
  editable.set_coordinate(options.coordinate);
  const ClosestPointQuery surface(target);
  Aligner aligner(editable, lines, target, surface, options, progress);
  aligner.run();
  result.aligned = aligner.aligned();
  mesh = editable.to_mesh();
  result.columns = refresh_columns(mesh);
  return result;
}

}  // namespace transformesh

#include "remesh/decimator.h"

#include <algorithm>
#include <cmath>

#include "remesh/guards/embedding_guard.h"
#include "remesh/halfedges/valences.h"
#include "remesh/operations/edge_collapser.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// Decimation proceeds in stages. Each stage reduces the number of faces to this share, and has its
/// own EmbeddingGuard, whose cells grow with the longest edge that it allows. A single guard for
/// the final edges would have many vertices in each cell, and each test would take long.
constexpr double stage_share = 0.4;
/// Edges of a stage may be this many times as long as those of equilateral triangles that cover the
/// area. The factor grows by allowance_growth after each stage that does not reach its goal.
constexpr double longest_edge = 5;
constexpr double allowance_growth = 1.6;
/// The weight of planes at borders and sharp edges, relative to the planes of faces. Larger weights
/// preserve borders and sharp edges better, and faces less well.
constexpr double border_weight = 10;
/// The weight of the squared length of an edge in its cost. The weight is so small that it decides
/// only on flat surfaces, where short edges are collapsed first. Measured by Hausdorff distances of
/// decimated CAD parts and spheres: 1e-13 gives the same as 1e-12, and 1e-10 up to 4 % more or
/// less. With 3e-8, vertices 1e-6 from a plane move before flat faces go.
constexpr double shortness = 1e-12;
/// Decimation within an error ends after a stage that removes at most 1/200 of the faces, and
/// refuses at most as many collapses because of edge lengths. A larger fraction leaves more faces;
/// a smaller one repeats refusals.
constexpr std::size_t few_share = 200;

/// A stage ends after this number of collapses was refused because edges would be too long. All
/// later collapses cost more, and the next stage allows longer edges.
std::size_t most_too_long(std::size_t faces) { return std::max<std::size_t>(10, faces / 50); }

}  // namespace

Decimator::Decimator(const Mesh& mesh, const DecimateOptions& options, std::optional<double> error,
                     const Progress& progress)
    : mesh_(mesh),
      wanted_(std::max(options.faces, least_faces)),
      progress_(progress),
      area_(surface_area(mesh)),
      first_faces_(mesh.faces.size()) {
  mesh_.set_coordinate(options.coordinate);
  if (options.feature_angle_deg < 180) mark_features(mesh_, options.feature_angle_deg);
  result_.faces = first_faces_;
  if (options.keep_out.surface != nullptr) {
    keep_out_.emplace(options.keep_out);
    result_.near_keep_out = keep_out_->count_near(mesh);
  }
  roles_.emplace(mesh_, options.keep_border);
  if (error) bound_.emplace(mesh_, mesh, *error);
  add_quadrics();
}

void Decimator::add_quadrics() {
  quadrics_.resize(mesh_.vertex_slots());
  versions_.assign(mesh_.vertex_slots(), 0);
  valences_ = valences_of(mesh_);
  for (Index face = 0; face < mesh_.face_slots(); ++face) {
    const Vec3 normal = mesh_.face_normal(face);
    const double length = normal.stableNorm();
    if (!(length > 0)) continue;
    const Quadric plane(normal / length, 1);
    for (Index i = 0; i < 3; ++i) quadrics_[mesh_.source(3 * face + i)] += plane;
  }
  for (Index h = 0; h < mesh_.halfedge_slots(); ++h)
    if (mesh_.has_halfedge(h) && is_line(mesh_, h)) add_border(h);
}

// Adds the plane through a border or sharp edge that is perpendicular to its face.
void Decimator::add_border(Index halfedge) {
  const Vec3 from = mesh_.position(mesh_.source(halfedge));
  const Vec3 along = mesh_.position(mesh_.target(halfedge)) - from;
  const Vec3 across = along.cross(mesh_.face_normal(halfedge / 3)).stableNormalized();
  const Quadric plane(across, border_weight);
  quadrics_[mesh_.source(halfedge)] += plane;
  quadrics_[mesh_.target(halfedge)] += plane;
}

/// Returns the sum of the quadrics of both ends of an edge, relative to the position of `source`.
Quadric Decimator::sum_at_source(Index source, Index target) const {
  return quadrics_[source] +
         quadrics_[target].relative_to(mesh_.position(source) - mesh_.position(target));
}

void Decimator::Places::add(double cost, const Vec3& position) {
  std::size_t place = count++;
  for (; place > 0 && cost < by_cost[place - 1].cost; --place) by_cost[place] = by_cost[place - 1];
  by_cost[place] = {cost, position};
}

/// Returns the positions to which an edge may be collapsed: the minimizer of the quadric, the
/// middle and both ends. If one end has a higher role than the other (vertex_role.h), that end is
/// the only position.
Decimator::Places Decimator::places(Index source, Index target) const {
  const Vec3 &from = mesh_.position(source), &to = mesh_.position(target);
  const Quadric sum = sum_at_source(source, target);
  const VertexRole first = (*roles_)[source], second = (*roles_)[target];
  const double length_cost = shortness * (to - from).squaredNorm();
  Places places;
  const auto add = [&](const Vec3& position) {
    places.add(sum.at(position - from) + length_cost, position);
  };
  if (first > second) {
    add(from);
  } else if (first < second) {
    add(to);
  } else {
    const Vec3 half = 0.5 * (to - from);
    add(from + sum.least_near(half));
    add(from + half);
    add(from);
    add(to);
  }
  return places;
}

/// Returns the collapse of the edge to the position with the given rank, if there is one. Edges at
/// a vertex of high valence wait until collapses around the vertex have removed faces. The test of
/// such an edge takes time proportional to the valence, and its collapse removes two faces at most.
std::optional<Decimator::Candidate> Decimator::candidate(Index halfedge, std::uint32_t rank) const {
  const Index source = mesh_.source(halfedge), target = mesh_.target(halfedge);
  if (std::max(valences_[source], valences_[target]) > usual_valence) return {};
  const Places all = places(source, target);
  if (rank >= all.count) return {};
  return Candidate{all.by_cost[rank].cost, halfedge, versions_[source] + versions_[target], rank};
}

void Decimator::fill_queue() {
  std::vector<Candidate> candidates;
  candidates.reserve(mesh_.halfedge_slots());
  for (Index h = 0; h < mesh_.halfedge_slots(); ++h)
    if (mesh_.is_edge(h))
      if (const auto found = candidate(h)) candidates.push_back(*found);
  queue_ = std::priority_queue<Candidate>({}, std::move(candidates));
}

void Decimator::push(Index halfedge, std::uint32_t rank) {
  if (const auto found = candidate(halfedge, rank)) queue_.push(*found);
}

/// Versions only grow, so that their sum tells whether an end of the edge was merged.
bool Decimator::is_current(const Candidate& candidate) const {
  if (!mesh_.has_halfedge(candidate.halfedge)) return false;
  const Index source = mesh_.source(candidate.halfedge);
  const Index target = mesh_.target(candidate.halfedge);
  return versions_[source] + versions_[target] == candidate.version;
}

void Decimator::push_around(Index vertex) {
  mesh_.for_each_neighbor(vertex, [&](Index, Index halfedge) { push(halfedge); });
}

/// Updates vertex data after a collapse. `quadric` is that of the merged vertex, and `apexes` are
/// the third corners of the removed faces.
void Decimator::merge(Index goes, Index stays, const Quadric& quadric,
                      std::span<const Index> apexes) {
  quadrics_[stays] = quadric;
  versions_[stays] = std::max(versions_[goes], versions_[stays]) + 1;
  valences_[stays] += valences_[goes] - 2 * static_cast<Index>(apexes.size());
  push_around(stays);
  for (const Index apex : apexes)
    if (--valences_[apex] == usual_valence) push_around(apex);
}

/// Collapses edges until `wanted` faces are left or the queue is empty. Returns how many collapses
/// were refused because an edge would have become longer than `longest`.
std::size_t Decimator::run_stage(std::size_t wanted, double longest) {
  EmbeddingGuard guard(mesh_, longest, keep_out_ ? &*keep_out_ : nullptr);
  EdgeCollapser collapser(mesh_, guard, *roles_, longest, bound_ ? &*bound_ : nullptr);
  std::size_t too_long = 0;
  fill_queue();
  while (result_.faces > wanted && !queue_.empty()) {
    const Candidate next = queue_.top();
    queue_.pop();
    if (!is_current(next)) continue;
    const Index source = mesh_.source(next.halfedge), target = mesh_.target(next.halfedge);
    std::vector<Index> apexes{mesh_.apex(next.halfedge)};
    if (!mesh_.is_border(next.halfedge))
      apexes.push_back(mesh_.apex(mesh_.opposite(next.halfedge)));
    const Vec3 wanted_position = places(source, target).by_cost[next.rank].position;
    const Vec3 from = mesh_.position(source);
    const Quadric sum = sum_at_source(source, target);
    const Index stays = collapser.collapse_to(next.halfedge, wanted_position);
    if (stays == no_index) {
      if (collapser.was_too_long() && ++too_long > most_too_long(result_.faces)) break;
      push(next.halfedge, next.rank + 1);
      continue;
    }
    result_.faces -= apexes.size();
    if (++result_.collapses % 1024 == 0)
      progress_("decimate", static_cast<double>(first_faces_ - result_.faces) /
                                static_cast<double>(first_faces_ - wanted_));
    merge(stays == source ? target : source, stays, sum.relative_to(mesh_.position(stays) - from),
          apexes);
  }
  result_.kept_out += guard.kept_out();
  return too_long;
}

DecimateResult Decimator::run() {
  double allowance = longest_edge;
  while (result_.faces > wanted_) {
    const std::size_t before = result_.faces;
    const auto share = static_cast<std::size_t>(stage_share * static_cast<double>(before));
    const std::size_t wanted = std::max(wanted_, share);
    const double edge = std::sqrt(4 / std::sqrt(3.0) * area_ / static_cast<double>(wanted));
    const std::size_t too_long = run_stage(wanted, allowance * edge);
    if (result_.faces <= wanted) continue;
    const std::size_t removed = before - result_.faces;
    if (removed == 0 && allowance > longest_edge * 1000) break;
    if (bound_ && std::max(removed, too_long) <= before / few_share) break;
    allowance *= allowance_growth;
  }
  if (bound_) {
    progress_("measure");
    result_.error_refused = bound_->refused();
    result_.error_bound = bound_->certified();
  }
  return result_;
}

}  // namespace transformesh

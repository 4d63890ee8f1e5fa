#include "clean/rounding/flat_vertices.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <deque>
#include <limits>
#include <optional>
#include <unordered_map>

#include "clean/rounding/broken_faces.h"
#include "clean/rounding/triangle_distance.h"

namespace transformesh {
namespace {

/// Least cosine of the angle between the normals of a face before and after a collapse (60
/// degrees). Angles of 76 degrees or more repair the same meshes with larger displacements
/// (docs/design/rounding.md).
constexpr double least_cosine = 0.5;

bool has_corner(const Face& face, Index v) { return face[0] == v || face[1] == v || face[2] == v; }

class FlatVertexRemover {
 public:
  FlatVertexRemover(const Mesh& input, Assembly& assembly, const std::vector<Index>& faces,
                    double steps, bool moves_input, const VertexGrids& grids);
  bool remove_all(Displacement& moved);

 private:
  /// The collapse of an edge to its vertex `end`, and the quality of the triangles that remain
  /// around the removed vertex.
  struct Collapse {
    Index end = no_index;
    /// Least relative height (height / longest edge) of the remaining triangles.
    double lowest = 0;
    double moved = 0;
  };

  const Vec3& at(Index v) const { return mesh_.positions[v]; }
  std::vector<Index> ring_of(Index v) const;
  bool has_link(Index v, Index end, const std::vector<Index>& ring) const;
  bool is_on_source(Index face, Index v) const;
  std::optional<double> movement(Index face, Index v, Index end) const;
  std::optional<Collapse> collapse_to(Index v, Index end) const;
  std::optional<Collapse> best_collapse(Index v, const std::vector<Index>& ring) const;
  std::optional<Collapse> shortest_collapse(Index v, const std::vector<Index>& ring) const;
  void collapse(Index v, Index end);
  void note_movement(const std::vector<Index>& star, const Displacement& moved);
  void enqueue(Index v);

  const Mesh& input_;
  Assembly& assembly_;
  Mesh& mesh_;
  double steps_;
  const VertexGrids& grids_;
  std::unordered_map<Index, std::vector<Index>> faces_at_;
  /// Contains each vertex that may be removed; the value is true if the vertex is in the queue.
  std::unordered_map<Index, bool> is_queued_;
  std::deque<Index> queue_;
  /// Displacement of each face by all collapses that changed it.
  std::unordered_map<Index, Displacement> moved_;
};

FlatVertexRemover::FlatVertexRemover(const Mesh& input, Assembly& assembly,
                                     const std::vector<Index>& faces, double steps,
                                     bool moves_input, const VertexGrids& grids)
    : input_(input), assembly_(assembly), mesh_(assembly.mesh), steps_(steps), grids_(grids) {
  for (const Index f : with_faces_around(mesh_, with_faces_around(mesh_, faces)))
    for (const Index v : mesh_.faces[f]) faces_at_[v].push_back(f);
  for (const Index f : faces)
    for (const Index v : mesh_.faces[f])
      if ((assembly_.vertex_is_new[v] || moves_input) && is_queued_.emplace(v, false).second)
        enqueue(v);
}

void FlatVertexRemover::enqueue(Index v) {
  const auto found = is_queued_.find(v);
  if (found == is_queued_.end() || found->second) return;
  found->second = true;
  queue_.push_back(v);
}

// Returns the vertices around `v` in order. Returns none if the faces of `v` are not one closed
// umbrella.
std::vector<Index> FlatVertexRemover::ring_of(Index v) const {
  std::unordered_map<Index, Index> next;
  const std::vector<Index>& star = faces_at_.at(v);
  for (const Index f : star) {
    const Face& c = mesh_.faces[f];
    const std::size_t i = c[0] == v ? 0 : c[1] == v ? 1 : 2;
    if (!next.emplace(c[(i + 1) % 3], c[(i + 2) % 3]).second) return {};
  }
  std::vector<Index> ring;
  if (star.size() < 3) return ring;
  const Face& first = mesh_.faces[star.front()];
  const Index start = first[0] == v ? first[1] : first[1] == v ? first[2] : first[0];
  for (Index w = start; ring.empty() || w != start;) {
    ring.push_back(w);
    const auto found = next.find(w);
    if (found == next.end() || ring.size() > star.size()) return {};
    w = found->second;
  }
  return ring.size() == star.size() ? ring : std::vector<Index>();
}

// True if the link condition holds for the edge from `v` to `end`. Both ends must have exactly two
// common faces, and no common neighbors except the third corners of these faces.
bool FlatVertexRemover::has_link(Index v, Index end, const std::vector<Index>& ring) const {
  std::vector<Index> common;
  std::size_t at_edge = 0;
  for (const Index f : faces_at_.at(end)) {
    at_edge += has_corner(mesh_.faces[f], v) ? 1 : 0;
    for (const Index w : mesh_.faces[f])
      if (w != end && std::find(ring.begin(), ring.end(), w) != ring.end() &&
          std::find(common.begin(), common.end(), w) == common.end())
        common.push_back(w);
  }
  return at_edge == 2 && common.size() == 2;
}

// True if vertex `v` is within the tolerance of the input face from which `face` is cut.
bool FlatVertexRemover::is_on_source(Index face, Index v) const {
  const Triangle source = triangle_of(input_, assembly_.source_face[face]);
  const Vec3 normal = unit_normal(source);
  const double reach = steps_ * grids_.step(mesh_, v);
  if (!(std::abs(height_over(source, normal, at(v))) <= reach)) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 inwards = normal.cross((source[(i + 1) % 3] - source[i]).stableNormalized());
    if (inwards.dot(at(v) - source[i]) < -reach) return false;
  }
  return true;
}

// Returns the distance by which the face moves if its corner `v` moves to `end`. Returns nothing if
// the distance exceeds the tolerance, or if the normal turns by more than 60 degrees.
std::optional<double> FlatVertexRemover::movement(Index face, Index v, Index end) const {
  const Triangle before = triangle_of(mesh_, face);
  Triangle after = before;
  for (std::size_t i = 0; i < 3; ++i)
    if (mesh_.faces[face][i] == v) after[i] = at(end);
  const Vec3 now = unit_normal(before), then = unit_normal(after);
  const double moved = then.isZero(0) ? 0 : std::abs(height_over(after, then, at(v)));
  const double moved_end = std::abs(height_over(before, now, at(end)));
  if (!(now.dot(then) > least_cosine) || moved > steps_ * grids_.step(mesh_, v) ||
      moved_end > steps_ * grids_.step(mesh_, end))
    return std::nullopt;
  return moved;
}

std::optional<FlatVertexRemover::Collapse> FlatVertexRemover::collapse_to(Index v,
                                                                          Index end) const {
  Collapse result{end, std::numeric_limits<double>::infinity(), 0};
  for (const Index f : faces_at_.at(v)) {
    if (has_corner(mesh_.faces[f], end)) continue;
    if (!is_on_source(f, end)) return std::nullopt;
    const std::optional<double> moved = movement(f, v, end);
    if (!moved) return std::nullopt;
    Triangle after = triangle_of(mesh_, f);
    for (std::size_t i = 0; i < 3; ++i)
      if (mesh_.faces[f][i] == v) after[i] = at(end);
    result.moved = std::max(result.moved, *moved);
    result.lowest = std::min(result.lowest, relative_height(after));
  }
  return result;
}

// Returns the collapse after which the least relative height (height / longest edge) of the
// triangles around the vertex is largest. Returns nothing if every collapse decreases the least
// relative height.
std::optional<FlatVertexRemover::Collapse> FlatVertexRemover::best_collapse(
    Index v, const std::vector<Index>& ring) const {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Index f : faces_at_.at(v))
    lowest = std::min(lowest, relative_height(triangle_of(mesh_, f)));
  std::optional<Collapse> best;
  for (const Index end : ring) {
    const std::optional<Collapse> found = collapse_to(v, end);
    const bool is_better = found && (best ? found->lowest > best->lowest : found->lowest >= lowest);
    if (is_better && has_link(v, end, ring)) best = found;
  }
  return best;
}

// Returns the collapse of the shortest edge at the vertex. Returns nothing if the edge is longer
// than half the tolerance. The collapse may turn the faces by any angle.
std::optional<FlatVertexRemover::Collapse> FlatVertexRemover::shortest_collapse(
    Index v, const std::vector<Index>& ring) const {
  std::optional<Collapse> shortest;
  double most = steps_ / 2 * grids_.step(mesh_, v);
  for (const Index end : ring) {
    const double length = (at(end) - at(v)).stableNorm();
    if (!(length <= most) || !has_link(v, end, ring)) continue;
    most = length;
    shortest = {end, 0, length};
  }
  return shortest;
}

void FlatVertexRemover::collapse(Index v, Index end) {
  for (const Index f : std::vector<Index>(std::move(faces_at_.at(v)))) {
    Face& corners = mesh_.faces[f];
    const bool vanishes = has_corner(corners, end);
    for (const Index w : corners)
      if (vanishes && w != v) std::erase(faces_at_.at(w), f);
    std::replace(corners.begin(), corners.end(), v, end);
    assembly_.face_is_new[f] = 1;
    if (!vanishes) faces_at_.at(end).push_back(f);
  }
  faces_at_.at(v).clear();
}

// Adds a movement to all faces at a removed vertex. After the collapse, each of them may contain
// points that any of them contained before. Hence all of them get the largest displacement.
void FlatVertexRemover::note_movement(const std::vector<Index>& star, const Displacement& moved) {
  Displacement total;
  for (const Index f : star) total.note(moved_[f]);
  total += moved;
  for (const Index f : star) moved_[f] = total;
}

bool FlatVertexRemover::remove_all(Displacement& moved) {
  while (!queue_.empty()) {
    const Index v = queue_.front();
    queue_.pop_front();
    is_queued_.at(v) = false;
    const std::vector<Index> ring = ring_of(v);
    std::optional<Collapse> best = shortest_collapse(v, ring);
    if (!best) best = best_collapse(v, ring);
    if (!best) continue;
    const double spacing = spacing_around(at(v), grids_.type());
    note_movement(faces_at_.at(v), {best->moved / spacing, best->moved});
    collapse(v, best->end);
    std::for_each(ring.begin(), ring.end(), [&](Index w) { enqueue(w); });
  }
  Displacement most;
  for (const auto& [face, total] : moved_) most.note(total);
  moved += most;
  return !moved_.empty();
}

}  // namespace

bool remove_flat_vertices(const Mesh& input, Assembly& assembly, const std::vector<Index>& faces,
                          double steps, bool moves_input, const VertexGrids& grids,
                          Displacement& moved) {
  return FlatVertexRemover(input, assembly, faces, steps, moves_input, grids).remove_all(moved);
}

}  // namespace transformesh

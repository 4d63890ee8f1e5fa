#include "fill/neck_loops.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "mesh/length_of.h"
#include "mesh/triangle.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

/// The surface beside a loop is divided into bands by the distance from the loop. The surface
/// widens if the area of a band is more than this multiple of the area on a cylinder whose
/// circumference is the length of the loop. With a factor below 1.5, cylinders with few edges
/// around them seem to widen, because their meshes are uneven. With 3, a neck between balls that
/// are less than three times as thick as the neck is not found.
constexpr double widening = 2;

double edge_length(const Mesh& mesh, Index h) {
  return length_of(mesh.positions[halfedge_target(mesh, h)] -
                   mesh.positions[halfedge_source(mesh, h)]);
}

/// Union-find structure for the faces of a Ball, which are numbered from 1. The number 0 stands for
/// all faces outside the ball.
class Unions {
 public:
  explicit Unions(std::size_t count) : parents_(count + 1) {
    for (Index i = 0; i < parents_.size(); ++i) parents_[i] = i;
  }
  /// Joins the sets of two faces. Returns false if both are already in one set.
  bool join(Index a, Index b) {
    a = root(a);
    b = root(b);
    parents_[a] = b;
    return a != b;
  }

 private:
  Index root(Index i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }

  std::vector<Index> parents_;
};

/// The vertices that paths of edges of a limited length reach from a base vertex, and the faces of
/// which all corners are reached.
class Ball {
 public:
  Ball(const Mesh& mesh, const HalfedgeStars& stars, Index base, double radius)
      : mesh_(mesh), stars_(stars) {
    grow(base, radius);
    count();
  }

  bool is_disk() const { return vertices_.size() + faces_.size() == edges_.size() + 1; }
  /// Returns the shortest loop through the base vertex that does not bound a set of faces of the
  /// ball.
  std::optional<NeckLoop> shortest_loop(double max_length) const;

 private:
  struct Reached {
    double distance = 0;
    Index from = no_index;
    bool is_final = false;
  };
  struct Closing {
    double length;
    Index halfedge;
  };

  void grow(Index base, double radius);
  void count();
  bool is_in(Index vertex) const {
    const auto found = reached_.find(vertex);
    return found != reached_.end() && found->second.is_final;
  }
  bool is_in_tree(Index h) const;
  Index number_of(Index h) const {
    const auto found = faces_.find(h / 3);
    return found == faces_.end() ? 0 : found->second;
  }
  std::vector<Closing> closing_edges() const;
  std::vector<Index> path_from(Index vertex) const;
  NeckLoop loop_of(const Closing& closing) const;

  const Mesh& mesh_;
  const HalfedgeStars& stars_;
  std::unordered_map<Index, Reached> reached_;
  std::vector<Index> vertices_;
  std::vector<Index> edges_;  ///< halfedge with the lower index of each edge in the ball
  std::unordered_map<Index, Index> faces_;  ///< maps the faces in the ball to numbers from 1
};

void Ball::grow(Index base, double radius) {
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  reached_[base] = {};
  queue.emplace(0, base);
  while (!queue.empty()) {
    const auto [distance, vertex] = queue.top();
    queue.pop();
    if (std::exchange(reached_[vertex].is_final, true)) continue;
    vertices_.push_back(vertex);
    stars_.visit(vertex, [&, from = vertex, way = distance](Index h) {
      const double there = way + edge_length(mesh_, h);
      if (there > radius) return;
      const auto [place, is_new] = reached_.try_emplace(halfedge_target(mesh_, h));
      if (!is_new && !(there < place->second.distance)) return;
      place->second = {there, from, false};
      queue.emplace(there, place->first);
    });
  }
}

void Ball::count() {
  for (const Index vertex : vertices_)
    stars_.visit(vertex, [&](Index h) {
      if (!is_in(halfedge_target(mesh_, h))) return;
      if (h < stars_.opposites()[h]) edges_.push_back(h);
      if (is_in(halfedge_source(mesh_, previous_halfedge(h))))
        faces_.try_emplace(h / 3, static_cast<Index>(faces_.size()) + 1);
    });
}

bool Ball::is_in_tree(Index h) const {
  const Index source = halfedge_source(mesh_, h);
  const Index target = halfedge_target(mesh_, h);
  return reached_.at(source).from == target || reached_.at(target).from == source;
}

/// Returns all edges of the ball that are not in the tree of shortest paths. Each closes a loop
/// through the base vertex. Sorted by the length of this loop, the longest first.
std::vector<Ball::Closing> Ball::closing_edges() const {
  std::vector<Closing> result;
  for (const Index h : edges_) {
    if (is_in_tree(h)) continue;
    const double way = reached_.at(halfedge_source(mesh_, h)).distance +
                       reached_.at(halfedge_target(mesh_, h)).distance;
    result.push_back({way + edge_length(mesh_, h), h});
  }
  std::sort(result.begin(), result.end(), [](const Closing& a, const Closing& b) {
    return std::tie(a.length, a.halfedge) > std::tie(b.length, b.halfedge);
  });
  return result;
}

std::vector<Index> Ball::path_from(Index vertex) const {
  std::vector<Index> path;
  for (; vertex != no_index; vertex = reached_.at(vertex).from) path.push_back(vertex);
  return path;
}

NeckLoop Ball::loop_of(const Closing& closing) const {
  NeckLoop loop{path_from(halfedge_source(mesh_, closing.halfedge)), closing.length};
  const std::vector<Index> back = path_from(halfedge_target(mesh_, closing.halfedge));
  loop.vertices.insert(loop.vertices.end(), back.rbegin() + 1, back.rend());
  return loop;
}

// Joins faces across closing edges, the edge of the longest loop first. An edge between faces that
// are already joined closes a loop that does not bound faces of the ball. A loop in which both
// paths share more vertices than the base is ignored: another base gives a shorter loop.
std::optional<NeckLoop> Ball::shortest_loop(double max_length) const {
  Unions unions(faces_.size());
  std::optional<NeckLoop> shortest;
  for (const Closing& closing : closing_edges()) {
    const Index h = closing.halfedge;
    if (unions.join(number_of(h), number_of(stars_.opposites()[h]))) continue;
    if (closing.length > max_length) continue;
    NeckLoop loop = loop_of(closing);
    std::vector<Index> sorted = loop.vertices;
    std::sort(sorted.begin(), sorted.end());
    const bool is_simple = std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
    if (is_simple && loop.vertices.size() >= 3) shortest = std::move(loop);
  }
  return shortest;
}

}  // namespace

std::vector<NeckLoop> narrow_loops(const Mesh& mesh, const HalfedgeStars& stars, double max_length,
                                   const Progress& progress) {
  const std::size_t vertices = mesh.positions.size();
  std::vector<std::optional<NeckLoop>> found(vertices);
  constexpr std::size_t at_once = 16384;  // number of vertices between two reports of progress
  for (std::size_t begin = 0; begin < vertices; begin += at_once) {
    progress("find necks", static_cast<double>(begin) / static_cast<double>(vertices));
    const std::size_t count = std::min(at_once, vertices - begin);
    parallel_for(count, 64, [&](std::size_t first, std::size_t last) {
      for (std::size_t v = begin + first; v < begin + last; ++v) {
        if (!stars.has(static_cast<Index>(v))) continue;
        const Ball ball(mesh, stars, static_cast<Index>(v), max_length / 2);
        if (!ball.is_disk()) found[v] = ball.shortest_loop(max_length);
      }
    });
  }

  std::vector<NeckLoop> loops;
  for (std::optional<NeckLoop>& loop : found)
    if (loop) loops.push_back(std::move(*loop));
  std::sort(loops.begin(), loops.end(), [](const NeckLoop& a, const NeckLoop& b) {
    return std::tie(a.length, a.vertices) < std::tie(b.length, b.vertices);
  });
  return loops;
}

/// Returns the halfedges along the loop, in its direction. Their faces are on the left side of the
/// loop.
std::vector<Index> NeckTest::halfedges_of(const NeckLoop& loop) const {
  std::vector<Index> result;
  for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
    const Index to = loop.vertices[(i + 1) % loop.vertices.size()];
    stars_.visit(loop.vertices[i], [&](Index h) {
      if (halfedge_target(mesh_, h) == to) result.push_back(h);
    });
  }
  return result;
}

Vec3 NeckTest::centroid(Index face) const {
  const auto [a, b, c] = triangle_of(mesh_, face);
  return (a + b + c) / 3;
}

/// Visits the faces on one side of the loop, in order of their distance from the loop. Distances
/// are lengths of paths over the centroids of neighboring faces. No path crosses a halfedge in
/// `barred`.
bool NeckTest::widens(double length, const std::vector<Index>& start,
                      const std::unordered_set<Index>& barred) const {
  using Entry = std::pair<double, Index>;
  const double width = length / 2;
  std::unordered_map<std::int64_t, double> areas;  // area of each band, by its index
  std::unordered_set<Index> is_done;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const Index h : start) queue.emplace(0, h / 3);
  while (!queue.empty()) {
    const auto [distance, face] = queue.top();
    queue.pop();
    if (!is_done.insert(face).second) continue;
    const auto [a, b, c] = triangle_of(mesh_, face);
    double& area = areas[static_cast<std::int64_t>(distance / width)];
    area += normal_of(a, b, c).norm() / 2;
    if (area > widening * length * width) return true;
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      const Index next = stars_.opposites()[h] / 3;
      if (barred.contains(h) || is_done.contains(next)) continue;
      queue.emplace(distance + length_of(centroid(next) - centroid(face)), next);
    }
  }
  return false;
}

bool NeckTest::is_neck(const NeckLoop& loop) const {
  const std::vector<Index> left = halfedges_of(loop);
  std::vector<Index> right;
  std::unordered_set<Index> barred = cuts_;
  for (const Index h : left) {
    right.push_back(stars_.opposites()[h]);
    barred.insert({h, right.back()});
  }
  return widens(loop.length, left, barred) && widens(loop.length, right, barred);
}

void NeckTest::note_cut(const NeckLoop& loop) {
  for (const Index h : halfedges_of(loop)) cuts_.insert({h, stars_.opposites()[h]});
}

}  // namespace transformesh

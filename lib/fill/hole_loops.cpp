#include "fill/hole_loops.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <span>
#include <utility>

#include "geometry/numbers/predicates.h"
#include "mesh/disjoint_sets.h"
#include "mesh/local_measures.h"
#include "mesh/separate_umbrellas.h"
#include "support/elementary/arctangent.h"

namespace transformesh {
namespace {

/// Umbrellas at one position belong to one surface if the cosine of the angle between their mean
/// normals is larger. Sides of a cube have 0, up to rounding. Bodies whose rims touch at a vertex
/// have about -1, and so have walls at a vertex where the outline of a missing floor touches
/// itself.
constexpr double least_cosine = -0.1;

/// At sharp edges, umbrellas belong to one surface if the angles between their borders are smaller
/// than the angles within the umbrellas by this factor. Both are equal at squares that touch.
constexpr double clearly_smaller = 0.9;

/// Umbrellas at one position that belong to one surface form a node.
struct Nodes {
  Umbrellas umbrellas;
  std::vector<Index> of_umbrella;
  std::vector<Vec3> normals;  ///< mean normal of each umbrella, zero if it is alone

  Index at(Index corner) const { return of_umbrella[umbrellas.of_corner[corner]]; }
};

/// Returns the sets of at least two border umbrellas at one position.
std::vector<std::vector<Index>> find_groups(const Mesh& mesh, const Umbrellas& umbrellas,
                                            const std::vector<Index>& border) {
  const auto position = [&](Index u) -> const Vec3& {
    return mesh.positions[umbrellas.vertex_of[u]];
  };
  std::vector<Index> members;
  for (const Index h : border) members.push_back(umbrellas.of_corner[h]);
  std::ranges::sort(members, [&](Index a, Index b) {
    const int sign = compare_positions(position(a), position(b));
    return sign != 0 ? sign < 0 : a < b;
  });
  std::vector<std::vector<Index>> groups;
  for (auto first = members.begin(), last = first; first != members.end(); first = last) {
    while (last != members.end() && position(*last) == position(*first)) ++last;
    if (last - first > 1) groups.emplace_back(first, last);
  }
  return groups;
}

void set_normals(const Mesh& mesh, const std::vector<std::vector<Index>>& groups, Nodes& nodes) {
  std::vector<char> is_grouped(nodes.normals.size(), 0);
  for (const auto& group : groups)
    for (const Index u : group) is_grouped[u] = 1;
  std::vector<std::pair<Index, Index>> faces;  // umbrella and face
  for (Index corner = 0; corner < 3 * mesh.faces.size(); ++corner)
    if (const Index u = nodes.umbrellas.of_corner[corner]; is_grouped[u] != 0)
      faces.emplace_back(u, corner / 3);
  std::ranges::sort(faces);
  for (std::size_t i = 0; i < faces.size();) {
    const Index u = faces[i].first;
    std::vector<Index> around;
    for (; i < faces.size() && faces[i].first == u; ++i) around.push_back(faces[i].second);
    nodes.normals[u] = vertex_normal(mesh, nodes.umbrellas.vertex_of[u], around);
  }
}

/// Compares the border edges of umbrellas.
class BorderAngles {
 public:
  BorderAngles(const Mesh& mesh, const Umbrellas& umbrellas, const std::vector<Index>& border)
      : mesh_(mesh),
        leaving_(umbrellas.vertex_of.size(), no_index),
        arriving_(umbrellas.vertex_of.size(), no_index) {
    for (const Index h : border) {
      leaving_[umbrellas.of_corner[h]] = h;
      arriving_[umbrellas.of_corner[next_halfedge(h)]] = h;
    }
  }

  /// True if the holes between two umbrellas are narrower than the umbrellas.
  bool are_neighbors(Index a, Index b) const {
    return angle(a, b) + angle(b, a) < clearly_smaller * (angle(a, a) + angle(b, b));
  }

 private:
  double angle(Index from, Index to) const {
    const Index in = arriving_[from], out = leaving_[to];
    const Vec3 u =
        (mesh_.positions[halfedge_source(mesh_, in)] - mesh_.positions[halfedge_target(mesh_, in)])
            .stableNormalized();
    const Vec3 v = (mesh_.positions[halfedge_target(mesh_, out)] -
                    mesh_.positions[halfedge_source(mesh_, out)])
                       .stableNormalized();
    return elementary::atan2(u.cross(v).norm(), u.dot(v));
  }

  const Mesh& mesh_;
  std::vector<Index> leaving_, arriving_;  ///< border halfedges of each umbrella
};

std::vector<Face> joined_faces(const Mesh& mesh, const Nodes& nodes) {
  std::vector<Face> faces = mesh.faces;
  for (Index h = 0; h < 3 * faces.size(); ++h)
    faces[h / 3][h % 3] = nodes.umbrellas.vertex_of[nodes.at(h)];
  return faces;
}

/// Separates nodes again at the ends of edges that would coincide, as at bodies whose rims touch
/// along an edge.
void separate_coincident_edges(const Mesh& mesh, Nodes& nodes) {
  const auto ends = [&](Index h) {
    return std::minmax({halfedge_source(mesh, h), halfedge_target(mesh, h)});
  };
  std::vector<char> is_separate(nodes.of_umbrella.size(), 0);
  const std::vector<Face> faces = joined_faces(mesh, nodes);
  const Edges edges(faces, mesh.positions.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const Index first = edges.halfedges(e)[0];
    if (std::ranges::all_of(edges.halfedges(e), [&](Index h) { return ends(h) == ends(first); }))
      continue;
    is_separate[nodes.at(first)] = is_separate[nodes.at(next_halfedge(first))] = 1;
  }
  for (Index u = 0; u < is_separate.size(); ++u)
    if (is_separate[nodes.of_umbrella[u]] != 0) nodes.of_umbrella[u] = u;
}

Nodes find_nodes(const Mesh& mesh, const std::vector<Index>& border) {
  Nodes nodes{find_umbrellas(mesh, Edges(mesh)), {}, {}};
  const std::size_t count = nodes.umbrellas.vertex_of.size();
  const std::vector<std::vector<Index>> groups = find_groups(mesh, nodes.umbrellas, border);
  nodes.normals.resize(count, Vec3::Zero());
  set_normals(mesh, groups, nodes);
  const BorderAngles angles(mesh, nodes.umbrellas, border);
  DisjointSets sets(count);
  for (const std::vector<Index>& group : groups)
    for (auto a = group.begin(); a != group.end(); ++a)
      for (auto b = a + 1; b != group.end(); ++b)
        if (sets.find(*a) != sets.find(*b) &&
            (nodes.normals[*a].dot(nodes.normals[*b]) > least_cosine ||
             angles.are_neighbors(*a, *b)))
          sets.join(*a, *b);
  for (Index u = 0; u < count; ++u) nodes.of_umbrella.push_back(sets.find(u));
  if (!groups.empty()) separate_coincident_edges(mesh, nodes);
  return nodes;
}

/// Follows borders from node to node, and cuts a loop off when a node is reached again.
class LoopWalk {
 public:
  LoopWalk(const Mesh& mesh, const Nodes& nodes, const std::vector<Index>& border)
      : mesh_(mesh), nodes_(nodes), place_(nodes.of_umbrella.size(), no_index) {
    for (const Index h : border) leaving_.emplace_back(nodes.at(h), h);
    std::ranges::sort(leaving_);
    is_used_.resize(3 * mesh.faces.size(), false);
  }

  std::vector<HoleLoop> loops(const std::vector<Index>& border) {
    for (const Index first : border)
      if (!is_used_[first]) walk(first);
    return std::move(loops_);
  }

 private:
  void walk(Index h);
  Index continuation(Index h) const;
  double angle_across_hole(Index arriving, Index leaving, const Vec3& normal) const;

  const Mesh& mesh_;
  const Nodes& nodes_;
  std::vector<Index> place_;                      ///< place of each node on the current path
  std::vector<std::pair<Index, Index>> leaving_;  ///< node and border halfedge that leaves it
  std::vector<bool> is_used_;
  std::vector<HoleLoop> loops_;
};

void LoopWalk::walk(Index h) {
  HoleLoop path;
  do {
    is_used_[h] = true;
    place_[nodes_.at(h)] = static_cast<Index>(path.size());
    path.push_back(h);
    if (const Index place = place_[nodes_.at(next_halfedge(h))]; place != no_index) {
      loops_.emplace_back(path.begin() + place, path.end());
      for (const Index cut : loops_.back()) place_[nodes_.at(cut)] = no_index;
      path.resize(place);
    }
    if (!path.empty()) h = continuation(path.back());
  } while (!path.empty());
}

/// Returns the unused border halfedge at the end of `h` at the least angle across the hole.
Index LoopWalk::continuation(Index h) const {
  const Index node = nodes_.at(next_halfedge(h));
  const auto first = std::lower_bound(leaving_.begin(), leaving_.end(), std::pair(node, Index{0}));
  const auto last = std::lower_bound(first, leaving_.end(), std::pair(node + 1, Index{0}));
  const std::span<const std::pair<Index, Index>> leaving(
      leaving_.data() + (first - leaving_.begin()), static_cast<std::size_t>(last - first));
  if (leaving.size() == 1) return leaving.front().second;
  Vec3 normal = Vec3::Zero();
  for (const auto& [same, out] : leaving) normal += nodes_.normals[nodes_.umbrellas.of_corner[out]];
  normal = normal.stableNormalized();
  Index best = no_index;
  double least = 0;
  for (const auto& [same, out] : leaving) {
    if (is_used_[out]) continue;
    const double angle = angle_across_hole(h, out, normal);
    if (best != no_index && angle >= least) continue;
    best = out;
    least = angle;
  }
  return best;
}

/// Returns the angle from a border halfedge to the next one, counter-clockwise around the normal;
/// in [0, 2 pi).
double LoopWalk::angle_across_hole(Index arriving, Index leaving, const Vec3& normal) const {
  const Vec3& center = mesh_.positions[halfedge_source(mesh_, leaving)];
  const auto direction_to = [&](Index v) {
    return (mesh_.positions[v] - center).stableNormalized();
  };
  const Vec3 from = direction_to(halfedge_source(mesh_, arriving));
  const Vec3 to = direction_to(halfedge_target(mesh_, leaving));
  const double angle = elementary::atan2(normal.dot(from.cross(to)),
                                         from.dot(to) - normal.dot(from) * normal.dot(to));
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

/// Separates the umbrellas of a node between which no loop passes. Then few faces are at each
/// vertex where many bodies touch.
void separate_unconnected(const std::vector<HoleLoop>& loops, Nodes& nodes) {
  DisjointSets sets(nodes.of_umbrella.size());
  for (const HoleLoop& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      sets.join(nodes.umbrellas.of_corner[next_halfedge(loop[i])],
                nodes.umbrellas.of_corner[loop[(i + 1) % loop.size()]]);
  for (Index u = 0; u < nodes.of_umbrella.size(); ++u) nodes.of_umbrella[u] = sets.find(u);
}

}  // namespace

std::vector<HoleLoop> join_touching_holes(Mesh& mesh, const std::vector<Index>& border) {
  Nodes nodes = find_nodes(mesh, border);
  std::vector<HoleLoop> loops = LoopWalk(mesh, nodes, border).loops(border);
  separate_unconnected(loops, nodes);
  mesh.faces = joined_faces(mesh, nodes);
  return loops;
}

void join_touching_loops(Mesh& mesh, const std::vector<std::vector<HoleLoop>>& holes) {
  std::vector<Index> first(mesh.positions.size(), no_index);
  DisjointSets vertices(mesh.positions.size());
  for (const std::vector<HoleLoop>& hole : holes) {
    if (hole.size() == 1) continue;
    std::vector<Index> sources;
    for (const HoleLoop& loop : hole)
      for (const Index h : loop) sources.push_back(halfedge_source(mesh, h));
    std::ranges::sort(sources, [&](Index a, Index b) {
      return compare_positions(mesh.positions[a], mesh.positions[b]) < 0;
    });
    for (std::size_t i = 1; i < sources.size(); ++i)
      if (mesh.positions[sources[i - 1]] == mesh.positions[sources[i]])
        vertices.join(sources[i - 1], sources[i]);
  }
  Nodes nodes{find_umbrellas(mesh, Edges(mesh)), {}, {}};
  for (Index u = 0; u < nodes.umbrellas.vertex_of.size(); ++u) {
    Index& node = first[vertices.find(nodes.umbrellas.vertex_of[u])];
    if (node == no_index) node = u;
    nodes.of_umbrella.push_back(node);
  }
  separate_coincident_edges(mesh, nodes);
  mesh.faces = joined_faces(mesh, nodes);
}

void separate_open_holes(Mesh& mesh, const std::vector<Face>& before) {
  Umbrellas umbrellas = find_umbrellas(mesh, Edges(mesh));
  for (Index u = 0; u < umbrellas.vertex_of.size(); ++u)
    if (const Index corner = umbrellas.first_corner[u]; corner / 3 < before.size())
      umbrellas.vertex_of[u] = before[corner / 3][corner % 3];
  std::vector<char> stays(mesh.positions.size(), 1);
  for (const Face& face : before)
    for (const Index v : face) stays[v] = 0;
  separate_umbrellas(mesh, umbrellas, stays);
}

}  // namespace transformesh

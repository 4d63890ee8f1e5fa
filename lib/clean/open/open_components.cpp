#include "clean/open/open_components.h"

#include <algorithm>
#include <map>
#include <utility>

#include "clean/exterior/angular_order.h"
#include "clean/open/borders.h"
#include "mesh/disjoint_sets.h"
#include "mesh/edges.h"

namespace transformesh {
namespace {

/// A halfedge that is not paired with another halfedge of its edge.
struct LooseHalfedge {
  Index set;
  int direction;  ///< 1 for a forward halfedge, -1 for a backward one
};

class Decomposition {
 public:
  Decomposition(const Mesh& mesh, const WeldedMesh& welded, bool is_stitched)
      : mesh_(mesh),
        faces_(is_stitched ? mesh.faces : faces_by_points(welded, mesh)),
        sets_(faces_.size()) {
    connect(Edges(faces_, std::max(mesh.positions.size(), welded.points.size())));
  }
  void open_sets(const WeldedMesh& welded, const FindEnclosed& find_enclosed);
  std::vector<Index> number(const WeldedMesh& welded);

 private:
  void connect(const Edges& edges);
  bool only_touch(Index halfedge, Index other) const;
  void connect_by_vertices(std::vector<Index>& halfedges);
  bool open_one_sided();
  bool has_surplus() const;
  bool open_surplus();
  std::pair<int, int> counts(const std::vector<LooseHalfedge>& edge) const;

  const Mesh& mesh_;
  /// The faces by vertex indices, if the mesh is stitched, or by welded points. Includes faces
  /// without area.
  std::vector<Face> faces_;
  DisjointSets sets_;
  /// For each edge that has unpaired halfedges, these halfedges.
  std::vector<std::vector<LooseHalfedge>> loose_;
  std::vector<char> is_open_;  ///< 1 for each set of connected faces that is an open component
};

// True if two halfedges coincide without common vertices, because two bodies touch there.
bool Decomposition::only_touch(Index halfedge, Index other) const {
  return halfedge_source(mesh_, halfedge) != halfedge_target(mesh_, other) &&
         halfedge_target(mesh_, halfedge) != halfedge_source(mesh_, other) &&
         overlap(mesh_, halfedge, other);
}

void Decomposition::connect(const Edges& edges) {
  std::vector<std::vector<Index>> loose;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto halfedges = edges.halfedges(e);
    if (halfedges.size() == 2 &&
        is_forward(faces_, halfedges[0]) != is_forward(faces_, halfedges[1]) &&
        !only_touch(halfedges[0], halfedges[1])) {
      sets_.join(halfedges[0] / 3, halfedges[1] / 3);
      continue;
    }
    loose.emplace_back(halfedges.begin(), halfedges.end());
    if (halfedges.size() > 2) connect_by_vertices(loose.back());
  }
  for (const std::vector<Index>& halfedges : loose) {
    std::vector<LooseHalfedge> edge;
    edge.reserve(halfedges.size());
    for (const Index h : halfedges)
      edge.push_back({sets_.find(h / 3), is_forward(faces_, h) ? 1 : -1});
    if (!edge.empty()) loose_.push_back(std::move(edge));
  }
}

// Pairs two halfedges of an edge, and connects their faces, if no third halfedge has the same two
// vertices. Removes the paired halfedges from the list.
void Decomposition::connect_by_vertices(std::vector<Index>& halfedges) {
  std::map<std::pair<Index, Index>, std::vector<Index>> by_vertices;
  for (const Index h : halfedges)
    by_vertices[std::minmax(mesh_.faces[h / 3][h % 3], mesh_.faces[h / 3][(h % 3 + 1) % 3])]
        .push_back(h);
  halfedges.clear();
  for (const auto& [vertices, of_edge] : by_vertices) {
    if (of_edge.size() == 2 && is_forward(faces_, of_edge[0]) != is_forward(faces_, of_edge[1])) {
      sets_.join(of_edge[0] / 3, of_edge[1] / 3);
    } else {
      halfedges.insert(halfedges.end(), of_edge.begin(), of_edge.end());
    }
  }
}

std::pair<int, int> Decomposition::counts(const std::vector<LooseHalfedge>& edge) const {
  int forward = 0, backward = 0;
  for (const LooseHalfedge& h : edge)
    if (!is_open_[h.set]) ++(h.direction > 0 ? forward : backward);
  return {forward, backward};
}

bool Decomposition::open_one_sided() {
  std::vector<Index> opened;
  for (const auto& edge : loose_) {
    const auto [forward, backward] = counts(edge);
    if (forward + backward == 0 || (forward > 0 && backward > 0)) continue;
    for (const LooseHalfedge& h : edge) opened.push_back(h.set);
  }
  for (const Index set : opened) is_open_[set] = 1;
  return !opened.empty();
}

bool Decomposition::open_surplus() {
  std::vector<Index> opened;
  for (const auto& edge : loose_) {
    const auto [forward, backward] = counts(edge);
    for (const LooseHalfedge& h : edge)
      if (!is_open_[h.set] && h.direction * (forward - backward) > 0) opened.push_back(h.set);
  }
  for (const Index set : opened) is_open_[set] = 1;
  return !opened.empty();
}

bool Decomposition::has_surplus() const {
  return std::any_of(loose_.begin(), loose_.end(), [&](const auto& edge) {
    const auto [forward, backward] = counts(edge);
    return forward != backward;
  });
}

void Decomposition::open_sets(const WeldedMesh& welded, const FindEnclosed& find_enclosed) {
  is_open_.assign(faces_.size(), 0);
  while (open_one_sided()) {
  }
  if (!has_surplus()) return;
  const std::vector<char> is_enclosed = find_enclosed();
  for (Index f = 0; f < is_enclosed.size(); ++f)
    if (is_enclosed[f]) is_open_[sets_.find(welded.face_of[f])] = 1;
  while (open_one_sided() || open_surplus()) {
  }
}

std::vector<Index> Decomposition::number(const WeldedMesh& welded) {
  std::vector<Index> number_of(faces_.size(), no_index);
  std::vector<Index> result;
  Index count = 0;
  for (const Index face : welded.face_of) {
    const Index set = sets_.find(face);
    if (is_open_[set] && number_of[set] == no_index) number_of[set] = count++;
    result.push_back(number_of[set]);
  }
  return result;
}

}  // namespace

std::vector<Index> find_open_components(const Mesh& mesh, const WeldedMesh& welded,
                                        bool is_stitched, const FindEnclosed& find_enclosed) {
  Decomposition decomposition(mesh, welded, is_stitched);
  decomposition.open_sets(welded, find_enclosed);
  return decomposition.number(welded);
}

}  // namespace transformesh

/// Properties of every result of an operation, checked without the library's connectivity.
#pragma once

#include <doctest/doctest.h>

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh::test {

/// Checks for an oriented manifold: every directed edge occurs once, and the faces at every vertex
/// form one umbrella.
inline bool is_oriented_manifold(const Mesh& mesh) {
  std::set<std::pair<Index, Index>> directed;
  // maps each corner to the next one
  std::vector<std::map<Index, Index>> links(mesh.positions.size());
  for (const Face& face : mesh.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = face[i];
      const Index b = face[(i + 1) % 3];
      if (a == b || !directed.emplace(a, b).second) return false;
      links[a][b] = face[(i + 2) % 3];
    }
  }
  for (const auto& link : links) {
    if (link.empty()) continue;
    // the start of the open chain, if there is one
    std::set<Index> reached;
    for (const auto& [from, to] : link) reached.insert(to);
    Index at = link.begin()->first;
    for (const auto& [from, to] : link) {
      if (!reached.count(from)) at = from;
    }
    std::size_t steps = 0;
    const Index start = at;
    for (auto next = link.find(at); next != link.end(); next = link.find(at)) {
      at = next->second;
      ++steps;
      if (at == start) break;
    }
    if (steps != link.size()) return false;
  }
  return true;
}

/// Returns the undirected edges with their numbers of faces.
inline std::map<std::pair<Index, Index>, int> edge_faces(const Mesh& mesh) {
  std::map<std::pair<Index, Index>, int> edges;
  for (const Face& face : mesh.faces) {
    for (std::size_t i = 0; i < 3; ++i) ++edges[std::minmax(face[i], face[(i + 1) % 3])];
  }
  return edges;
}

inline bool is_closed(const Mesh& mesh) {
  for (const auto& [edge, faces] : edge_faces(mesh)) {
    if (faces != 2) return false;
  }
  return true;
}

/// V - E + F over the vertices in use.
inline long euler_number(const Mesh& mesh) {
  std::set<Index> used;
  for (const Face& face : mesh.faces) used.insert(face.begin(), face.end());
  return static_cast<long>(used.size()) - static_cast<long>(edge_faces(mesh).size()) +
         static_cast<long>(mesh.faces.size());
}

inline bool is_same(const Mesh& first, const Mesh& second) {
  return first.positions == second.positions && first.faces == second.faces;
}

}  // namespace transformesh::test

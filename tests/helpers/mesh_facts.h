/// Facts about meshes, found without the library: by counting, and by testing all pairs of faces.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh::test {

/// The properties that define a closed oriented manifold. Later members are valid only if the first
/// is true.
struct Count {
  bool is_closed_and_oriented = true;  // every halfedge occurs once, and so does its opposite
  bool is_manifold = true;             // the faces around each vertex are one cycle
  bool has_isolated_vertices = false;
  std::vector<long> genera;  // genus per component, sorted
};

/// Maps each halfedge to the third vertex of its face.
struct Halfedges {
  std::map<std::pair<Index, Index>, Index> third;
  std::vector<std::size_t> valence;
  std::vector<Index> some_neighbor;
  bool are_unique = true;

  explicit Halfedges(const Mesh& mesh)
      : valence(mesh.positions.size(), 0), some_neighbor(mesh.positions.size()) {
    for (const Face& face : mesh.faces)
      for (int i = 0; i < 3; ++i) {
        const Index a = face[i];
        const Index b = face[(i + 1) % 3];
        if (!third.try_emplace({a, b}, face[(i + 2) % 3]).second || a == b) are_unique = false;
        ++valence[a];
        some_neighbor[a] = b;
      }
  }

  bool are_paired() const {
    return are_unique && std::all_of(third.begin(), third.end(), [&](const auto& halfedge) {
             return third.contains({halfedge.first.second, halfedge.first.first});
           });
  }

  /// True if walking around the vertex visits all of its faces.
  bool is_one_cycle(Index vertex) const {
    std::size_t steps = 0;
    Index neighbor = some_neighbor[vertex];
    do {
      neighbor = third.at({vertex, neighbor});
      ++steps;
    } while (neighbor != some_neighbor[vertex] && steps <= valence[vertex]);
    return steps == valence[vertex];
  }

  /// Returns for each vertex the representative of its component: one vertex, the same for all
  /// vertices of the component.
  std::vector<Index> components() const {
    std::vector<Index> parent(valence.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](Index v) {
      while (parent[v] != v) v = parent[v] = parent[parent[v]];
      return v;
    };
    for (const auto& [halfedge, apex] : third) parent[root(halfedge.first)] = root(halfedge.second);
    for (Index& vertex : parent) vertex = root(vertex);
    return parent;
  }
};

inline Count count(const Mesh& mesh) {
  const Halfedges halfedges(mesh);
  Count result;
  result.is_closed_and_oriented = halfedges.are_paired();
  if (!result.is_closed_and_oriented) return result;

  const std::vector<Index> component = halfedges.components();
  std::map<Index, long> vertices;
  for (Index v = 0; v < component.size(); ++v) {
    if (halfedges.valence[v] == 0) {
      result.has_isolated_vertices = true;
      continue;
    }
    if (!halfedges.is_one_cycle(v)) result.is_manifold = false;
    ++vertices[component[v]];
  }

  std::map<Index, long> edges;  // halfedges per component: each edge counts twice
  for (const auto& [halfedge, apex] : halfedges.third) ++edges[component[halfedge.first]];
  // Let H be the number of halfedges. Then 3 F = 2 E = H, so V - E + F = V - H / 6.
  for (const auto& [root, number] : vertices)
    result.genera.push_back((2 - number + edges[root] / 6) / 2);
  std::sort(result.genera.begin(), result.genera.end());
  return result;
}

inline double signed_volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.faces)
    sum += mesh.positions[a].dot(mesh.positions[b].cross(mesh.positions[c]));
  return sum / 6;
}

/// Returns the sum of the solid angles of all faces, divided by 4 pi. Reference: Van Oosterom &
/// Strackee, "The solid angle of a plane triangle", IEEE Trans. Biomedical Engineering 30(2), 1983.
inline double winding_number(const Mesh& mesh, const Vec3& point) {
  double sum = 0;
  for (const Face& face : mesh.faces) {
    const Vec3 a = mesh.positions[face[0]] - point;
    const Vec3 b = mesh.positions[face[1]] - point;
    const Vec3 c = mesh.positions[face[2]] - point;
    sum += 2 * std::atan2(a.dot(b.cross(c)), a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                                                 b.dot(c) * a.norm() + c.dot(a) * b.norm());
  }
  return sum / (4 * std::numbers::pi);
}

inline double orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a);
}

/// Self-intersections, computed in doubles.
struct Crossings {
  std::size_t pairs = 0;  // pairs of faces of which an edge of one properly crosses the other
  // Smallest absolute volume in the orientation tests of these pairs. The result of a test is
  // uncertain if its volume is small.
  double flattest = 1e300;
};

class IntersectionCounter {
 public:
  explicit IntersectionCounter(const Mesh& mesh) : mesh_(mesh) {}

  Crossings all() {
    struct Interval {
      double low, high;
      Index face;
    };
    std::vector<Interval> intervals;
    for (Index f = 0; f < mesh_.faces.size(); ++f) {
      const auto box = box_of(f);
      intervals.push_back({box.first.x(), box.second.x(), f});
    }
    std::sort(intervals.begin(), intervals.end(),
              [](const Interval& a, const Interval& b) { return a.low < b.low; });
    for (std::size_t i = 0; i < intervals.size(); ++i)
      for (std::size_t j = i + 1; j < intervals.size() && intervals[j].low <= intervals[i].high;
           ++j)
        if (boxes_overlap(intervals[i].face, intervals[j].face))
          test(intervals[i].face, intervals[j].face);
    return result_;
  }

 private:
  std::pair<Vec3, Vec3> box_of(Index f) const {
    const auto& [a, b, c] = mesh_.faces[f];
    const auto& p = mesh_.positions;
    return {p[a].cwiseMin(p[b]).cwiseMin(p[c]), p[a].cwiseMax(p[b]).cwiseMax(p[c])};
  }

  bool boxes_overlap(Index f, Index g) const {
    const auto first = box_of(f);
    const auto second = box_of(g);
    return (first.first.array() <= second.second.array()).all() &&
           (second.first.array() <= first.second.array()).all();
  }

  void test(Index f, Index g) {
    const bool crosses_one = crosses(f, g);
    const bool crosses_other = crosses(g, f);
    if (crosses_one || crosses_other) ++result_.pairs;
  }

  // True if an edge of f that has no corner of g passes through the interior of g.
  bool crosses(Index f, Index g) {
    const Face& other = mesh_.faces[g];
    const auto is_of_g = [&](Index v) { return v == other[0] || v == other[1] || v == other[2]; };
    bool found = false;
    for (int i = 0; i < 3; ++i) {
      const Index p = mesh_.faces[f][i];
      const Index q = mesh_.faces[f][(i + 1) % 3];
      if (is_of_g(p) || is_of_g(q)) continue;
      found |= segment_crosses(mesh_.positions[p], mesh_.positions[q], mesh_.positions[other[0]],
                               mesh_.positions[other[1]], mesh_.positions[other[2]]);
    }
    return found;
  }

  bool segment_crosses(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
    const double at_p = orientation(a, b, c, p);
    const double at_q = orientation(a, b, c, q);
    if ((at_p > 0) == (at_q > 0)) return false;
    const std::array<double, 3> around = {orientation(p, q, a, b), orientation(p, q, b, c),
                                          orientation(p, q, c, a)};
    const bool is_inside = (around[0] > 0) == (around[1] > 0) && (around[1] > 0) == (around[2] > 0);
    if (!is_inside) return false;
    for (const double value : {at_p, at_q, around[0], around[1], around[2]})
      result_.flattest = std::min(result_.flattest, std::abs(value));
    return true;
  }

  const Mesh& mesh_;
  Crossings result_;
};

inline Crossings crossings(const Mesh& mesh) { return IntersectionCounter(mesh).all(); }

inline double mean_edge(const Mesh& mesh) {
  double sum = 0;
  for (const Face& face : mesh.faces)
    for (int i = 0; i < 3; ++i)
      sum += (mesh.positions[face[i]] - mesh.positions[face[(i + 1) % 3]]).norm();
  return sum / (3.0 * static_cast<double>(mesh.faces.size()));
}

/// Returns the mean over all faces of their smallest angle, in degrees.
inline double mean_smallest_angle(const Mesh& mesh) {
  double sum = 0;
  for (const Face& face : mesh.faces) {
    double cosine = -1;
    for (int i = 0; i < 3; ++i) {
      const Vec3& apex = mesh.positions[face[i]];
      const Vec3 u = (mesh.positions[face[(i + 1) % 3]] - apex).normalized();
      const Vec3 v = (mesh.positions[face[(i + 2) % 3]] - apex).normalized();
      cosine = std::max(cosine, u.dot(v));
    }
    sum += std::acos(std::min(cosine, 1.0)) * 180 / std::numbers::pi;
  }
  return sum / static_cast<double>(mesh.faces.size());
}

}  // namespace transformesh::test

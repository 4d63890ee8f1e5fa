#include "corpus/chains/mesh_facts.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace chains {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point3 = Kernel::Point_3;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;

/// Returns a number for each point. Points with equal coordinates have equal numbers.
std::vector<std::uint32_t> number_places(const std::vector<Point>& points) {
  std::vector<std::uint32_t> order(points.size()), places(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return points[a] < points[b]; });
  std::uint32_t place = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && points[order[i]] != points[order[i - 1]]) ++place;
    places[order[i]] = place;
  }
  return places;
}

/// Decides whether two faces intersect outside of the corners and edges with equal coordinates.
class PairTest {
 public:
  explicit PairTest(const TriangleMesh& mesh) : places_(number_places(mesh.points)) {
    for (const Triangle& face : mesh.faces) {
      Corners corners;
      for (std::size_t i = 0; i < 3; ++i) {
        const Point& p = mesh.points[face[i]];
        corners.places[i] = places_[face[i]];
        corners.points[i] = Point3(p[0], p[1], p[2]);
      }
      faces_.push_back(corners);
    }
  }

  bool has_area(std::size_t f) const {
    const auto& [a, b, c] = faces_[f].points;
    return !CGAL::collinear(a, b, c);
  }

  CGAL::Bbox_3 box(std::size_t f) const {
    const auto& [a, b, c] = faces_[f].points;
    return a.bbox() + b.bbox() + c.bbox();
  }

  bool meet(std::size_t f, std::size_t g) const {
    Corners first = faces_[f], second = faces_[g];
    std::size_t shared = 0;  // common corners are moved to the front of both
    for (std::size_t i = shared; i < 3; ++i)
      for (std::size_t j = shared; j < 3; ++j)
        if (first.places[i] == second.places[j]) {
          first.swap(i, shared);
          second.swap(j, shared);
          ++shared;
          break;
        }
    const auto& [a, b, c] = first.points;
    const auto& [p, q, r] = second.points;
    if (shared == 3) return true;
    if (shared == 2)
      return CGAL::coplanar(a, b, c, r) && CGAL::coplanar_orientation(a, b, c, r) == CGAL::POSITIVE;
    const Kernel::Triangle_3 one(a, b, c), other(p, q, r);
    if (shared == 1)
      return CGAL::do_intersect(one, Kernel::Segment_3(q, r)) ||
             CGAL::do_intersect(other, Kernel::Segment_3(b, c));
    return CGAL::do_intersect(one, other);
  }

 private:
  struct Corners {
    std::array<std::uint32_t, 3> places;
    std::array<Point3, 3> points;
    void swap(std::size_t i, std::size_t j) {
      std::swap(places[i], places[j]);
      std::swap(points[i], points[j]);
    }
  };
  std::vector<std::uint32_t> places_;
  std::vector<Corners> faces_;
};

void count_meetings(const TriangleMesh& mesh, MeshFacts& facts) {
  const PairTest test(mesh);
  std::vector<Box> boxes;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
    if (test.has_area(f))
      boxes.emplace_back(test.box(f), f);
    else
      ++facts.no_area;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& one, const Box& other) {
    facts.intersections += test.meet(one.info(), other.info()) ? 1 : 0;
  });
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;

void count_edges(const TriangleMesh& mesh, MeshFacts& facts) {
  std::vector<Edge> edges;
  for (const Triangle& face : mesh.faces)
    for (std::size_t i = 0; i < 3; ++i) edges.emplace_back(face[i], face[(i + 1) % 3]);
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i > 0 && edges[i] == edges[i - 1]) ++facts.bad_edges;
    const Edge opposite(edges[i].second, edges[i].first);
    if (!std::binary_search(edges.begin(), edges.end(), opposite)) ++facts.open_edges;
  }
}

/// Counts edges, compared by position, without a partner in the opposite direction. Edges that
/// rounding has collapsed do not count.
void count_unpaired_places(const TriangleMesh& mesh, MeshFacts& facts) {
  const std::vector<std::uint32_t> places = number_places(mesh.points);
  std::vector<std::pair<Edge, int>> edges;
  for (const Triangle& face : mesh.faces)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = places[face[i]], to = places[face[(i + 1) % 3]];
      edges.emplace_back(std::minmax(from, to), from < to ? 1 : from > to ? -1 : 0);
    }
  std::sort(edges.begin(), edges.end());
  int sum = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    sum += edges[i].second;
    if (i + 1 < edges.size() && edges[i + 1].first == edges[i].first) continue;
    facts.unpaired_places += static_cast<std::size_t>(std::abs(sum));
    sum = 0;
  }
}

std::size_t find_root(std::vector<std::uint32_t>& parents, std::uint32_t i) {
  while (parents[i] != i) i = parents[i] = parents[parents[i]];
  return i;
}

void unite(std::vector<std::uint32_t>& parents, std::uint32_t i, std::uint32_t j) {
  parents[find_root(parents, i)] = static_cast<std::uint32_t>(find_root(parents, j));
}

std::size_t count_roots(const std::vector<std::uint32_t>& parents, const std::vector<char>& used) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < parents.size(); ++i) count += parents[i] == i && used[i] != 0 ? 1 : 0;
  return count;
}

/// Unites corners of faces across edges. The corners at a vertex are then one set if its faces form
/// one umbrella.
void count_umbrellas(const TriangleMesh& mesh, MeshFacts& facts) {
  std::vector<std::uint32_t> parents(3 * mesh.faces.size());
  std::iota(parents.begin(), parents.end(), 0U);
  std::map<Edge, std::uint32_t> halfedges;
  const auto corner = [](std::uint32_t f, std::uint32_t i) { return 3 * f + i % 3; };
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
    for (std::uint32_t i = 0; i < 3; ++i)
      halfedges[{mesh.faces[f][i], mesh.faces[f][(i + 1) % 3]}] = corner(f, i);
  for (const auto& [edge, from] : halfedges) {
    const auto opposite = halfedges.find({edge.second, edge.first});
    if (opposite == halfedges.end()) continue;
    const std::uint32_t other = opposite->second;
    unite(parents, from, corner(other / 3, other % 3 + 1));
    unite(parents, corner(from / 3, from % 3 + 1), other);
  }
  std::vector<std::size_t> umbrellas(mesh.points.size());
  for (std::uint32_t c = 0; c < parents.size(); ++c)
    if (parents[c] == c) ++umbrellas[mesh.faces[c / 3][c % 3]];
  for (const std::size_t count : umbrellas) facts.bad_vertices += count > 1 ? 1 : 0;
}

void count_components(const TriangleMesh& mesh, MeshFacts& facts) {
  std::vector<std::uint32_t> parents(mesh.points.size());
  std::iota(parents.begin(), parents.end(), 0U);
  std::vector<char> used(mesh.points.size());
  for (const auto& [a, b, c] : mesh.faces) {
    unite(parents, a, b);
    unite(parents, b, c);
    used[a] = used[b] = used[c] = 1;
  }
  facts.components = count_roots(parents, used);
}

void measure(const TriangleMesh& mesh, MeshFacts& facts) {
  const Point origin = mesh.points.empty() ? Point{} : mesh.points.front();
  for (const Triangle& face : mesh.faces) {
    std::array<Point, 3> t;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) t[i][k] = mesh.points[face[i]][k] - origin[k];
    Point normal{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      normal[k] =
          (t[1][i] - t[0][i]) * (t[2][j] - t[0][j]) - (t[1][j] - t[0][j]) * (t[2][i] - t[0][i]);
      facts.volume += t[0][k] * normal[k] / 6;
    }
    facts.area +=
        std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]) / 2;
  }
}

}  // namespace

MeshFacts judge(const TriangleMesh& mesh) {
  MeshFacts facts;
  facts.faces = mesh.faces.size();
  for (const Point& p : mesh.points)
    if (!std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); }))
      ++facts.bad_coordinates;
  for (const auto& [a, b, c] : mesh.faces)
    if (std::max({a, b, c}) >= mesh.points.size() || a == b || b == c || c == a)
      ++facts.bad_indices;
  if (!facts.is_valid()) return facts;
  count_edges(mesh, facts);
  count_unpaired_places(mesh, facts);
  count_umbrellas(mesh, facts);
  count_components(mesh, facts);
  count_meetings(mesh, facts);
  measure(mesh, facts);
  return facts;
}

}  // namespace chains

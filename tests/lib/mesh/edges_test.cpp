#include "mesh/edges.h"

#include <doctest/doctest.h>

#include <map>

#include "transformesh/control.h"

using namespace transformesh;

namespace {

using Halfedges = std::vector<Index>;

/// Returns the halfedges of each edge by a sorted map, which also has the order of the edges.
std::map<std::pair<Index, Index>, Halfedges> edges_by_map(const std::vector<Face>& faces) {
  std::map<std::pair<Index, Index>, Halfedges> edges;
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const Index from = faces[f][i], to = faces[f][(i + 1) % 3];
      if (from != to) edges[std::minmax(from, to)].push_back(static_cast<Index>(3 * f + i));
    }
  return edges;
}

void check_edges(const std::vector<Face>& faces, std::size_t vertices) {
  const auto expected = edges_by_map(faces);
  const Edges edges(faces, vertices);
  REQUIRE(edges.size() == expected.size());
  std::size_t e = 0;
  for (const auto& [ends, halfedges] : expected) {
    const auto found = edges.halfedges(e++);
    REQUIRE(std::equal(found.begin(), found.end(), halfedges.begin(), halfedges.end()));
  }
}

/// Returns faces with corners in a window that moves through the vertices. A window as wide as the
/// mesh gives faces in no spatial order.
std::vector<Face> random_faces(std::size_t count, Index vertices, Index window) {
  std::vector<Face> faces;
  unsigned state = 1;
  const auto next = [&](std::size_t f) {
    state = state * 1664525U + 1013904223U;
    const auto first = static_cast<Index>(f * (vertices - window) / count);
    return first + (state >> 8) % window;
  };
  for (std::size_t f = 0; f < count; ++f) faces.push_back({next(f), next(f), next(f)});
  return faces;
}

}  // namespace

TEST_CASE(
    "edges and their halfedges are sorted, for any number of threads and any order of faces") {
  for (const Index window : {20U, 500U, 10'000U})
    for (const std::size_t count : {0U, 1U, 4096U, 4097U, 30'000U})
      for (const int threads : {1, 2, 5}) {
        CAPTURE(window);
        CAPTURE(count);
        CAPTURE(threads);
        const ThreadLimit limit(threads);
        check_edges(random_faces(count, 10'000, window), 10'000);
      }
}

TEST_CASE("an edge of many faces, and vertices without faces") {
  std::vector<Face> faces;
  for (Index f = 0; f < 9000; ++f) faces.push_back({7000, 3, 10'000 + f});
  for (const int threads : {1, 3}) {
    const ThreadLimit limit(threads);
    check_edges(faces, 30'000);
  }
}

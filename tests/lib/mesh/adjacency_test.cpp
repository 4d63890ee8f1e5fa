#include "mesh/adjacency.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"

using namespace transformesh;

namespace {

/// Returns the opposite halfedges by their definition, in quadratic time.
std::vector<Index> opposites_by_search(const Mesh& mesh) {
  const Index count = static_cast<Index>(3 * mesh.faces.size());
  std::vector<Index> result(count, no_index);
  for (Index h = 0; h < count; ++h) {
    const Index source = halfedge_source(mesh, h);
    const Index target = halfedge_target(mesh, h);
    if (source == target) continue;
    Index across = no_index;
    int along = 0;
    for (Index other = 0; other < count; ++other) {
      const Index from = halfedge_source(mesh, other);
      const Index to = halfedge_target(mesh, other);
      if (from == target && to == source) across = other;
      if ((from == target && to == source) || (from == source && to == target)) ++along;
    }
    if (along == 2) result[h] = across;
  }
  return result;
}

/// Faces with random indices, with repeated vertices and crowded edges.
Mesh random_soup(unsigned seed, std::size_t faces, Index vertices) {
  Mesh mesh;
  mesh.positions.assign(vertices, Vec3::Zero());
  const auto next = [&] {
    seed = seed * 1664525U + 1013904223U;
    return (seed >> 16) % vertices;
  };
  for (std::size_t f = 0; f < faces; ++f) {
    const Index a = next();
    const Index b = next();
    mesh.faces.push_back({a, b, next()});
  }
  return mesh;
}

}  // namespace

TEST_CASE("opposite halfedges of a closed mesh pair up") {
  const Mesh mesh = test::torus(2, 0.5, 7, 5);
  const auto opposite = opposite_halfedges(mesh);
  REQUIRE(opposite.size() == 3 * mesh.faces.size());
  for (Index h = 0; h < opposite.size(); ++h) {
    REQUIRE(opposite[h] != no_index);
    CHECK(opposite[opposite[h]] == h);
    CHECK(halfedge_source(mesh, opposite[h]) == halfedge_target(mesh, h));
    CHECK(halfedge_target(mesh, opposite[h]) == halfedge_source(mesh, h));
  }
}

TEST_CASE("opposite halfedges agree with a search, on soups too") {
  CHECK(opposite_halfedges(test::grid(4)) == opposites_by_search(test::grid(4)));
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Mesh soup = random_soup(seed, 40, 5 + 2 * seed);
    CHECK(opposite_halfedges(soup) == opposites_by_search(soup));
  }
}

TEST_CASE("a vertex of high valence is sorted like any other") {
  Mesh umbrella;
  umbrella.positions.assign(1002, Vec3::Zero());
  for (Index i = 1000; i > 0; --i) umbrella.faces.push_back({0, i, i + 1});
  CHECK(opposite_halfedges(umbrella) == opposites_by_search(umbrella));
}

TEST_CASE("vertex faces ascend and name each face once") {
  Mesh mesh = test::tetrahedron();
  mesh.faces.push_back({1, 1, 3});
  mesh.positions.emplace_back(9, 9, 9);
  const VertexFaces around(mesh);
  const auto list = [&](Index v) { return std::vector<Index>(around[v].begin(), around[v].end()); };
  CHECK(list(0) == std::vector<Index>{0, 1, 2});
  CHECK(list(1) == std::vector<Index>{0, 1, 3, 4});
  CHECK(list(2) == std::vector<Index>{0, 2, 3});
  CHECK(list(3) == std::vector<Index>{1, 2, 3, 4});
  CHECK(list(4).empty());
}

TEST_CASE("a mesh without faces has no halfedges") {
  CHECK(opposite_halfedges(Mesh{}).empty());
  Mesh points;
  points.positions.assign(3, Vec3::Ones());
  CHECK(opposite_halfedges(points).empty());
  CHECK(VertexFaces(points)[2].empty());
}

TEST_CASE("closed manifolds get opposites from edges, and other meshes do not") {
  const auto closed = [](const Mesh& mesh) {
    return closed_opposites(mesh, opposite_halfedges(mesh));
  };
  const Mesh mesh = test::joined(test::torus(2, 0.5, 7, 5), test::icosphere(1));
  REQUIRE(closed(mesh));
  CHECK(*closed(mesh) == opposites_by_search(mesh));

  Mesh open = mesh;
  open.faces.pop_back();
  CHECK(!closed(open));
  Mesh turned = mesh;
  std::swap(turned.faces[3][0], turned.faces[3][1]);
  CHECK(!closed(turned));
  // Two bodies that share a vertex, then an edge.
  Mesh pinched = mesh;
  for (Face& face : pinched.faces)
    for (Index& vertex : face)
      if (vertex == mesh.faces.back()[0]) vertex = 0;
  CHECK(!closed(pinched));
  Mesh hinged = pinched;
  for (Face& face : hinged.faces)
    for (Index& vertex : face)
      if (vertex == mesh.faces.back()[1]) vertex = mesh.faces[0][1];
  CHECK(!closed(hinged));
}

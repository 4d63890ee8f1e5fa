/// Singular edges that copies of their ends do not separate, in solids of unit cells.
#include "clean/stitch/split_singular_edges.h"

#include <doctest/doctest.h>

#include <map>

#include "clean/exterior/angular_order.h"
#include "clean/stitch/pair_halfedges.h"
#include "helpers/mesh_facts.h"
#include "helpers/random.h"
#include "mesh/umbrellas.h"

using namespace transformesh;

namespace {

constexpr int side = 4;

/// Returns the boundary of filled cells, with one vertex per corner; faces are oriented outwards.
Mesh boundary_of(const std::vector<char>& filled) {
  const auto at = [&](const std::array<int, 3>& c) {
    for (const int x : c)
      if (x < 0 || x >= side) return false;
    return filled[static_cast<std::size_t>(c[0] + side * (c[1] + side * c[2]))] == 1;
  };
  Mesh mesh;
  std::map<std::array<int, 3>, Index> vertex_at;
  const auto vertex = [&](const std::array<int, 3>& c) {
    const auto [entry, is_new] =
        vertex_at.try_emplace(c, static_cast<Index>(mesh.positions.size()));
    if (is_new) mesh.positions.emplace_back(c[0], c[1], c[2]);
    return entry->second;
  };
  for (int i = 0; i < side * side * side; ++i) {
    const std::array<int, 3> cell{i % side, i / side % side, i / side / side};
    if (!at(cell)) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int way : {0, 1}) {
        std::array<int, 3> next = cell;
        next.at(axis) += way == 1 ? 1 : -1;
        if (at(next)) continue;
        std::array<std::array<int, 3>, 4> corners;
        corners.fill(cell);
        for (std::size_t k = 0; k < 4; ++k) {
          corners.at(k).at(axis) += way;
          corners.at(k).at((axis + 1) % 3) += k == 1 || k == 2 ? 1 : 0;
          corners.at(k).at((axis + 2) % 3) += k >= 2 ? 1 : 0;
        }
        if (way == 0) std::swap(corners[1], corners[3]);
        const Index a = vertex(corners[0]), c = vertex(corners[2]);
        mesh.faces.push_back({a, vertex(corners[1]), c});
        mesh.faces.push_back({a, c, vertex(corners[3])});
      }
    }
  }
  return mesh;
}

/// The boundary with a vertex for each umbrella, as stitching leaves it before edges are split.
struct Parted {
  Mesh mesh;
  std::vector<Index> opposite;

  explicit Parted(const Mesh& whole) : mesh(whole) {
    const Edges edges(mesh);
    opposite = pair_across_inside(mesh.faces, edges, [&](std::span<const Index> halfedges) {
      return sort_around_edge(whole, halfedges);
    });
    const Umbrellas umbrellas = find_umbrellas(mesh.faces, opposite);
    mesh.positions.clear();
    for (const Index v : umbrellas.vertex_of) mesh.positions.push_back(whole.positions[v]);
    for (Index h = 0; h < umbrellas.of_corner.size(); ++h)
      mesh.faces[h / 3][h % 3] = umbrellas.of_corner[h];
  }
};

std::size_t singular_edges(const Mesh& mesh) {
  const Edges edges(mesh);
  std::size_t count = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) count += edges.halfedges(e).size() > 2 ? 1 : 0;
  return count;
}

void check_split(Parted parted) {
  const Mesh before = parted.mesh;
  const std::size_t singular = singular_edges(before);
  const EdgeSplits splits = split_singular_edges(parted.mesh, parted.opposite);
  const Mesh& mesh = parted.mesh;
  CHECK(splits.edges >= singular);
  CHECK((splits.edges == 0) == (singular == 0));
  const test::Count count = test::count(mesh);
  CHECK(count.is_closed_and_oriented);
  CHECK(count.is_manifold);
  CHECK(test::signed_volume(mesh) == doctest::Approx(test::signed_volume(before)));

  // Every sheet at a singular edge gets one midpoint and two more faces.
  REQUIRE(mesh.positions.size() == before.positions.size() + splits.vertices.size());
  CHECK(mesh.faces.size() == before.faces.size() + 2 * splits.vertices.size());
  for (std::size_t i = 0; i < splits.vertices.size(); ++i) {
    const auto& [face, ends] = splits.vertices[i];
    const Vec3 middle = (mesh.positions[ends[0]] + mesh.positions[ends[1]]) / 2;
    CHECK(mesh.positions[before.positions.size() + i] == middle);
    CHECK(face < before.faces.size());
  }
  for (const Index source : splits.face_source)
    CHECK(std::count(splits.cut_faces.begin(), splits.cut_faces.end(), source) > 0);
  for (Index h = 0; h < parted.opposite.size(); ++h) {
    const Index other = parted.opposite[h];
    REQUIRE(parted.opposite[other] == h);
    CHECK(halfedge_source(mesh, other) == halfedge_target(mesh, h));
    CHECK(halfedge_target(mesh, other) == halfedge_source(mesh, h));
  }
}

}  // namespace

TEST_CASE("an edge in which two cells touch between two plates is split once") {
  std::vector<char> filled(side * side * side, 0);
  const auto fill = [&](int x, int y, int z) {
    filled[static_cast<std::size_t>(x + side * (y + side * z))] = 1;
  };
  for (int i = 0; i < 4; ++i) {
    fill(i % 2, i / 2, 0);
    fill(i % 2, i / 2, 2);
  }
  fill(0, 0, 1);
  fill(1, 1, 1);
  Parted parted(boundary_of(filled));
  CHECK(singular_edges(parted.mesh) == 1);
  const EdgeSplits splits = split_singular_edges(parted.mesh, parted.opposite);
  CHECK(splits.edges == 1);
  CHECK(splits.vertices.size() == 2);
  CHECK(splits.face_source.size() == 4);
  CHECK(singular_edges(parted.mesh) == 0);
}

TEST_CASE("solids of random cells become manifolds of the same volume") {
  std::size_t split = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    std::vector<char> filled(side * side * side);
    for (char& cell : filled) cell = random.below(10) < 5 ? 1 : 0;
    const Parted parted(boundary_of(filled));
    split += singular_edges(parted.mesh);
    check_split(parted);
  }
  CHECK(split > 20);
}

/// Border loops of holes that touch, in meshes with known holes.
#include "fill/hole_loops.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "transformesh/components.h"
#include "transformesh/fill.h"
#include "transformesh/intersect.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"
#include "transformesh/stitch.h"

using namespace transformesh;

namespace {

/// Returns a flat sheet of n x n squares without those for which is_missing(x, y) holds.
template <class IsMissing>
Mesh sheet(Index n, double scale, const IsMissing& is_missing) {
  Mesh mesh;
  for (Index y = 0; y <= n; ++y)
    for (Index x = 0; x <= n; ++x) mesh.positions.emplace_back(scale * x, scale * y, 0);
  for (Index y = 0; y < n; ++y)
    for (Index x = 0; x < n; ++x) {
      const Index a = y * (n + 1) + x, c = a + n + 1;
      if (is_missing(x, y)) continue;
      mesh.faces.push_back({a, a + 1, c + 1});
      mesh.faces.push_back({a, c + 1, c});
    }
  return mesh;
}

std::vector<std::size_t> sizes_of_loops(Mesh mesh) {
  std::vector<std::size_t> sizes;
  for (const HoleLoop& loop : join_touching_holes(mesh, check_manifold(mesh).border_halfedges)) {
    sizes.push_back(loop.size());
    std::set<Index> vertices;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      vertices.insert(halfedge_source(mesh, loop[i]));
      CHECK(halfedge_target(mesh, loop[i]) == halfedge_source(mesh, loop[(i + 1) % loop.size()]));
    }
    CHECK(vertices.size() == loop.size());
  }
  std::ranges::sort(sizes);
  return sizes;
}

Mesh stitched(Mesh mesh) {
  stitch(mesh);
  return mesh;
}

}  // namespace

TEST_CASE("each of several touching holes has a loop, whether vertices are shared or copied") {
  using Sizes = std::vector<std::size_t>;
  for (const double scale : {1e-150, 1.0, 1e150}) {
    const Mesh two = sheet(4, scale, [](Index x, Index y) { return x == y && (x == 1 || x == 2); });
    CHECK(sizes_of_loops(two) == Sizes{4, 4, 16});
    CHECK(sizes_of_loops(stitched(two)) == Sizes{4, 4, 16});
    // The square in the middle is connected with the others only at its four vertices.
    const Mesh four = sheet(5, scale, [](Index x, Index y) {
      return (x == 2) != (y == 2) && x % 4 != 0 && y % 4 != 0;
    });
    CHECK(sizes_of_loops(four) == Sizes{4, 4, 4, 4, 20});
    CHECK(sizes_of_loops(stitched(four)) == Sizes{4, 4, 4, 4, 20});
  }
}

TEST_CASE("three holes around a vertex have three loops") {
  // Faces 2 i and 2 i + 1 alternate around each inner vertex.
  Mesh mesh = sheet(4, 1, [](Index, Index) { return false; });
  std::vector<bool> keep;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    keep.push_back(f % 2 == 1 ||
                   std::ranges::find(mesh.faces[f], Index{12}) == mesh.faces[f].end());
  mesh = select_faces(mesh, keep);
  CHECK(sizes_of_loops(mesh) == std::vector<std::size_t>{3, 3, 3, 16});
  CHECK(sizes_of_loops(stitched(mesh)) == std::vector<std::size_t>{3, 3, 3, 16});
}

TEST_CASE("holes that touch at a sharp edge have a loop each") {
  // Two sides of a wedge with an angle of 30 degrees, with a missing face on each side.
  Mesh mesh = sheet(6, 1, [](Index, Index) { return false; });
  const auto first_face = [](std::ptrdiff_t square) { return 2 * (6 * square + square); };
  mesh.faces.erase(mesh.faces.begin() + first_face(3));
  mesh.faces.erase(mesh.faces.begin() + first_face(2) + 1);
  for (Vec3& p : mesh.positions)
    if (p.y() > 3) p = {p.x(), 3 - (p.y() - 3) * 0.8660254037844386, -(p.y() - 3) / 2};
  CHECK(sizes_of_loops(mesh) == std::vector<std::size_t>{3, 3, 24});
  CHECK(sizes_of_loops(stitched(mesh)) == std::vector<std::size_t>{3, 3, 24});
  const FillResult result = fill_holes(mesh, {.max_edges = 4, .refine = false});
  CHECK(result.filled() == 2);
  CHECK(check_manifold(mesh).is_manifold());
  CHECK(surface_area(mesh) == doctest::Approx(36));
}

TEST_CASE("open bodies whose rims touch keep their loops") {
  const auto without_top = [](Mesh mesh) {
    std::erase_if(mesh.faces, [&](const Face& f) {
      return std::ranges::all_of(f, [&](Index v) { return mesh.positions[v].z() == 1; });
    });
    return mesh;
  };
  // Their rims touch at a vertex, then along an edge.
  for (const double y : {1.0, 0.0}) {
    const Mesh boxes = test::joined(without_top(test::cube()),
                                    without_top(test::cuboid({1, y, 0}, {2, y + 1, 1})));
    CHECK(sizes_of_loops(boxes) == std::vector<std::size_t>{4, 4});
  }
}

TEST_CASE("vertices whose holes stay open are as they were") {
  const Mesh two = sheet(4, 1, [](Index x, Index y) { return x == y && (x == 1 || x == 2); });
  for (const Mesh& mesh : {two, stitched(two)}) {
    Mesh joined = mesh;
    join_touching_holes(joined, check_manifold(joined).border_halfedges);
    separate_open_holes(joined, mesh.faces);
    CHECK(check_manifold(joined).is_manifold());
    if (check_manifold(mesh).is_manifold()) CHECK(joined.faces == mesh.faces);
    CHECK(joined.positions.size() == stitched(two).positions.size());
  }
}

TEST_CASE("a ball without random faces becomes the ball") {
  const Mesh ball = test::icosphere(3);
  test::Random random(5);
  for (const double share : {0.03, 0.1, 0.2}) {
    std::vector<bool> keep;
    for (std::size_t f = 0; f < ball.faces.size(); ++f)
      keep.push_back(random.uniform(0, 1) > share);
    const Mesh open = select_faces(ball, keep);
    REQUIRE_FALSE(check_manifold(open).is_manifold());
    for (Mesh mesh : {open, stitched(open)}) {
      const FillResult result = fill_holes(mesh);
      CHECK(result.filled() == result.holes);
      const ManifoldReport found = check_manifold(mesh);
      CHECK((found.is_manifold() && found.is_oriented() && found.is_closed()));
      CHECK(find_intersections(mesh).empty());
      CHECK(volume(mesh) == doctest::Approx(volume(ball)).epsilon(0.01));
    }
  }
}

/// Sums along edges and misoriented edges, for books of faces with known sums.
#include "clean/stitch/orientation_check.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"
#include "mesh/edges.h"

using namespace transformesh;

namespace {

/// Faces along the edge from vertex 0 to vertex 1; `forward` and `backward` count those that
/// traverse it in either direction.
Mesh book(int forward, int backward) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 0, 1}};
  for (int i = 0; i < forward + backward; ++i) {
    mesh.positions.emplace_back(std::cos(i), std::sin(i), 0);
    const auto v = static_cast<Index>(i) + 2;
    mesh.faces.push_back(i < forward ? Face{0, 1, v} : Face{v, 1, 0});
  }
  return mesh;
}

}  // namespace

TEST_CASE("the sum at an edge is the number of forward faces minus that of the others") {
  for (int forward = 0; forward < 4; ++forward) {
    for (int backward = 0; backward < 4; ++backward) {
      if (forward + backward == 0) continue;
      const Mesh mesh = book(forward, backward);
      const Edges edges(mesh);
      CHECK(sum_along(mesh.faces, edges.halfedges(0)) == forward - backward);
      const bool is_oriented = std::abs(forward - backward) <= 1;
      CHECK(describe_misorientation(mesh).empty() == is_oriented);
    }
  }
}

TEST_CASE("a misoriented edge is reported with its faces and the number of such edges") {
  CHECK(describe_misorientation(book(2, 0)) ==
        "faces 0 and 1 traverse the edge from vertex 0 at (0, 0, 0) to vertex 1 at "
        "(0, 0, 1) in the same direction");
  CHECK(describe_misorientation(book(1, 3)) ==
        "faces 1, 2 and 3 traverse the edge from vertex 1 at (0, 0, 1) to vertex 0 "
        "at (0, 0, 0) in the same direction, and only 1 in the opposite direction");
  CHECK(describe_misorientation(book(8, 0))
            .starts_with("faces 0, 1, 2, 3, 4 and 3 more traverse the edge"));
  Mesh ball = test::icosphere(1);
  std::swap(ball.faces[5][0], ball.faces[5][1]);
  CHECK(describe_misorientation(ball).ends_with(" (the first of 3 such edges)"));
}

TEST_CASE("faces that name a vertex twice say nothing") {
  Mesh mesh = test::grid(2);
  CHECK(describe_misorientation(mesh).empty());
  for (int i = 0; i < 3; ++i) mesh.faces.push_back({0, 0, 1});
  CHECK(describe_misorientation(mesh).empty());
}

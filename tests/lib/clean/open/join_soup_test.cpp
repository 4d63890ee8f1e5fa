#include "clean/open/join_soup.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "helpers/shapes.h"
#include "mesh/touching_borders.h"
#include "transformesh/errors.h"
#include "transformesh/manifold.h"

using namespace transformesh;

TEST_CASE("a soup becomes a mesh, and other meshes stay unchanged") {
  const Mesh ball = test::icosphere(2);
  Mesh soup = test::soup_of(ball);
  CHECK(join_soup(soup).joined_vertices == 3 * ball.faces.size() - ball.positions.size());
  CHECK(check_manifold(soup).is_closed());
  CHECK(soup.positions.size() == ball.positions.size());

  Mesh open = ball;
  open.faces.resize(100);
  const std::vector<Face> faces = open.faces;
  CHECK(join_soup(open).joined_vertices == 0);
  CHECK(open.faces == faces);
  CHECK(open.positions.size() == ball.positions.size());
}

TEST_CASE("closed bodies that touch keep their own vertices") {
  Mesh bodies = test::joined(test::cube(), test::moved(test::cube(), {1, 0, 0}));
  const std::size_t before = bodies.positions.size();
  CHECK(join_soup(bodies).joined_vertices == 0);
  CHECK(bodies.positions.size() == before);
}

TEST_CASE("open bodies that touch at their borders keep their own vertices") {
  Mesh box = test::cube();
  std::erase_if(box.faces, [&](const Face& f) {
    return std::ranges::all_of(f, [&](Index v) { return box.positions[v].z() == 1; });
  });
  CHECK(box.faces.size() == 10);
  Mesh bodies = test::joined(box, test::moved(box, {1, 0, 0}));
  CHECK(count_touching_borders(bodies) > 0);
  const std::vector<Face> faces = bodies.faces;
  CHECK(join_soup(bodies).joined_vertices == 0);
  CHECK(bodies.faces == faces);
}

TEST_CASE("inconsistently oriented faces are refused") {
  Mesh soup = test::soup_of(test::cube());
  std::swap(soup.faces[3][1], soup.faces[3][2]);
  const std::vector<Face> faces = soup.faces;
  try {
    join_soup(soup);
    FAIL("accepted");
  } catch (const InputError& error) {
    CHECK(error.kind() == ErrorKind::not_oriented);
  }
  CHECK(soup.faces == faces);
  stitch(soup, {.orient = true});
  CHECK(join_soup(soup).joined_vertices == 0);
  CHECK(check_manifold(soup).is_closed());
}

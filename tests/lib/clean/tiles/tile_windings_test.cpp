/// Winding numbers counted in a stream, compared with sums of solid angles.
#include "clean/tiles/tile_windings.h"

#include <doctest/doctest.h>

#include <cmath>

#include "helpers/arrangement_facts.h"
#include "helpers/mesh_facts.h"
#include "transformesh/errors.h"

using namespace transformesh;

TEST_CASE("points of boxes have the winding numbers of solid angles, nested copies included") {
  const Mesh once = test::random_balls(5, 6);
  const Mesh mesh = test::joined(test::joined(once, once), test::scaled(once, 2));
  std::vector<Box> boxes;
  for (int i = 0; i < 27; ++i) {
    const Vec3 low = Vec3(i % 3, i / 3 % 3, i / 9).array() * .5 - .75;
    boxes.push_back(i == 13 ? Box() : Box(low, low.array() + .5));
  }
  boxes.emplace_back(Vec3(-.01, -.01, -.01), Vec3(.01, .01, .01));
  TileWindings windings(boxes);
  for (Index f = 0; f < mesh.faces.size(); ++f) windings.add(triangle_of(mesh, f));
  int largest = 0;
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    if (b == 13) continue;
    const ReferencePoint point = windings.of_box(b);
    CHECK(boxes[b].contains(point.position));
    CHECK(point.winding == std::lround(test::winding_number(mesh, point.position)));
    largest = std::max(largest, point.winding);
  }
  CHECK(largest > 1);
  CHECK(windings.of_box(13).winding == 0);
}

TEST_CASE("if the box is a point on a diagonal, every ray is undecided") {
  const Mesh cube = test::cube();
  const Vec3 middle = Vec3::Constant(.5);
  TileWindings windings({Box(middle, middle)});
  for (Index f = 0; f < cube.faces.size(); ++f) windings.add(triangle_of(cube, f));
  CHECK_THROWS_AS(windings.of_box(0), GoalError);
}

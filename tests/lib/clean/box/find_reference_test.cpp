/// Winding numbers of reference points, against sums of solid angles.
#include "clean/box/find_reference.h"

#include <doctest/doctest.h>

#include <cmath>

#include "helpers/arrangement_facts.h"
#include "helpers/mesh_facts.h"
#include "transformesh/errors.h"

using namespace transformesh;

TEST_CASE("a reference point has the winding number of solid angles") {
  const Mesh mesh = test::random_balls(3, 6);
  int largest = 0;
  for (int i = 0; i < 8; ++i) {
    const Vec3 low = Vec3(i & 1, i >> 1 & 1, i >> 2 & 1) * .5 - Vec3::Constant(.5);
    const Box box(low, low + Vec3::Constant(.5));
    const ReferencePoint point = find_reference(mesh, {Vec3(-50, -50, -50), 0}, box);
    CHECK(box.contains(point.position));
    CHECK(point.winding == std::lround(test::winding_number(mesh, point.position)));
    largest = std::max(largest, point.winding);
  }
  CHECK(largest > 0);
}

TEST_CASE("a box that is one point on an edge has no reference point") {
  const Mesh cube = test::cube();
  const Vec3 corner(1, 1, .5);
  CHECK_THROWS_AS(find_reference(cube, {Vec3(-1, -1, -1), 0}, {corner, corner}), GoalError);
}

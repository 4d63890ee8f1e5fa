#include "boolean/edited_solid.h"

#include <doctest/doctest.h>

#include "helpers/mesh_facts.h"
#include "helpers/shapes.h"

using namespace transformesh;

TEST_CASE("an edited solid finds its faces, and no removed ones") {
  const Mesh cube = test::cube();
  EditedSolid solid(test::joined(cube, test::moved(cube, Vec3(5, 0, 0))));
  CHECK(solid.faces_touching(Box(Vec3(5.5, 0.5, 0.5), Vec3(9, 9, 9))).front() >= 12);
  CHECK(solid.winding_at(Vec3(0.3, 0.4, 0.6)) == 1);
  CHECK(solid.winding_at(Vec3(1.3, 0.4, 0.6)) == 0);
  CHECK(!solid.winding_at(Vec3(1, 0.4, 0.6)));
  std::vector<Index> first(12);
  for (Index f = 0; f < 12; ++f) first[f] = f;
  solid.replace(first, test::moved(cube, Vec3(0, 5, 0)), std::vector<Index>(8, no_index));
  CHECK(solid.faces() == 24);
  CHECK(solid.faces_touching(Box(Vec3(-1, -1, -1), Vec3(2, 2, 2))).empty());
  CHECK(solid.winding_at(Vec3(0.3, 5.4, 0.6)) == 1);
  CHECK(test::signed_volume(solid.take()) == doctest::Approx(2));
}

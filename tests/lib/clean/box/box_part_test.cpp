#include "clean/box/box_part.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "helpers/mesh_facts.h"
#include "helpers/shape_options.h"
#include "helpers/shapes.h"
#include "transformesh/errors.h"

using namespace transformesh;

TEST_CASE("a part that is the whole mesh has all faces, and a reference point outside") {
  const Mesh mesh = test::moved(test::workload("folded", 2000, 1), {3, 4, 5});
  const Region region = whole_region(mesh);
  CHECK(region.is_whole);
  CHECK(region.held.contains(Vec3(1e300, -1e300, 0)));
  CHECK(std::abs(test::winding_number(mesh, region.reference.position)) < 1e-6);
  CHECK(region.reference.winding == 0);
}

TEST_CASE("a region that is too small for its faces is refused") {
  const Mesh mesh = test::workload("folded", 2000, 1);
  std::vector<bool> own(mesh.faces.size(), false);
  for (Index f = 0; f < 100; ++f) own[f] = true;
  CleanResult counts;
  Region region = whole_region(mesh);
  CHECK(BoxPart(mesh, region, own, {}, Progress()).clean(counts));
  region.is_whole = false;
  CHECK(BoxPart(mesh, region, own, {}, Progress()).clean(counts));
}

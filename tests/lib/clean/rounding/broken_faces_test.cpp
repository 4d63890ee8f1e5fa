/// Faces that rounding breaks are found, and collapsed faces are removed without opening the
/// surface.
#include "clean/rounding/broken_faces.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "helpers/assembly_of.h"
#include "helpers/cgal_oracle.h"
#include "helpers/mesh_facts.h"
#include "helpers/shapes.h"

namespace transformesh {

TEST_CASE("intersecting faces are broken where one of them is new, and faces without area always") {
  Assembly assembly =
      test::assembly_of(test::joined(test::cube(), test::moved(test::cube(), {0.5, 0.4, 0.3})));
  const auto [all, pairs] = find_broken_faces(assembly);
  CHECK(all.size() > 6);
  CHECK(pairs == test::count_self_intersections(assembly.mesh));
  assembly.face_is_new.assign(24, 0);
  CHECK(find_broken_faces(assembly).faces.empty());
  assembly.face_is_new[all.front()] = 1;
  const auto [some, some_pairs] = find_broken_faces(assembly);
  CHECK(std::find(some.begin(), some.end(), all.front()) != some.end());
  // All pairs contain the one new face.
  CHECK(some_pairs == some.size() - 1);
  CHECK(some_pairs > 0);

  Assembly flat = test::assembly_of(test::cube());
  CHECK(find_broken_faces(flat).faces.empty());
  flat.mesh.positions[1] = flat.mesh.positions[0];
  CHECK(!find_broken_faces(flat).faces.empty());
}

TEST_CASE("broken faces with common corners count as one place") {
  const Mesh two = test::joined(test::cube(), test::moved(test::cube(), {5, 0, 0}));
  CHECK(count_places(two, {}) == 0);
  CHECK(count_places(two, {0, 1, 4}) == 1);
  CHECK(count_places(two, {0, 12, 13}) == 2);
}

TEST_CASE("a collapsed edge removes its two faces, and a flattened body vanishes") {
  Assembly cube = test::assembly_of(test::cube());
  cube.mesh.positions[1] = cube.mesh.positions[0];
  CHECK(drop_collapsed_faces(cube));
  CHECK(cube.mesh.faces.size() == 10);
  CHECK(test::count(cube.mesh).is_closed_and_oriented);
  CHECK(cube.source_face.size() == 10);
  CHECK(!drop_collapsed_faces(cube));

  Assembly flat = test::assembly_of(test::tetrahedron());
  flat.mesh.positions[3] = flat.mesh.positions[0];
  CHECK(drop_collapsed_faces(flat));
  CHECK(flat.mesh.faces.empty());
}

TEST_CASE("coincident faces are removed as far as they cancel out") {
  const Mesh cube = test::cube();
  Assembly three = test::assembly_of(test::joined(test::joined(cube, test::reversed(cube)), cube));
  CHECK(drop_collapsed_faces(three));
  CHECK(three.mesh.faces.size() == 12);
  CHECK(test::signed_volume(three.mesh) == doctest::Approx(1));
}

}  // namespace transformesh

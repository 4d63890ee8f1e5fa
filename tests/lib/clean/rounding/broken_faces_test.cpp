/// Faces that rounding breaks are found, and collapsed faces are removed without opening the
/// surface.
#include "clean/rounding/broken_faces.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "helpers/assembly_of.h"
#include "helpers/cgal_oracle.h"
#include "helpers/mesh_facts.h"
#include "helpers/shapes.h"

using namespace transformesh;

TEST_CASE("intersecting faces are broken where one of them is new, and faces without area always") {
  Assembly assembly =
      test::assembly_of(test::joined(test::cube(), test::moved(test::cube(), {0.5, 0.4, 0.3})));
  const BrokenFaces all = find_broken_faces(assembly);
  CHECK(all.faces.size() > 6);
  CHECK(all.pairs.size() == test::count_self_intersections(assembly.mesh));
  CHECK(all.disjoint.size() + all.faces.size() == 24);
  assembly.face_is_new.assign(24, 0);
  CHECK(find_broken_faces(assembly).faces.empty());
  const Index first = all.faces.front();
  assembly.face_is_new[first] = 1;
  const BrokenFaces some = find_broken_faces(assembly);
  CHECK(std::find(some.faces.begin(), some.faces.end(), first) != some.faces.end());
  // All pairs contain the one new face.
  CHECK(some.pairs.size() == some.faces.size() - 1);
  CHECK(!some.pairs.empty());

  Assembly flat = test::assembly_of(test::cube());
  CHECK(find_broken_faces(flat).faces.empty());
  flat.mesh.positions[1] = flat.mesh.positions[0];
  CHECK(!find_broken_faces(flat).faces.empty());
}

TEST_CASE("a search that knows disjoint faces finds the same broken faces after others moved") {
  Mesh mesh = test::joined(test::icosphere(2), test::moved(test::icosphere(2), {2.05, 0, 0}));
  Assembly assembly = test::assembly_of(mesh);
  const BrokenFaces before = find_broken_faces(assembly);
  CHECK(before.faces.empty());
  CHECK(before.disjoint.size() == mesh.faces.size());
  const DisjointFaces known(assembly.mesh, before.disjoint);
  for (Vec3& position : assembly.mesh.positions)
    if (position.x() > 0.8) position.x() += position.x() < 1.025 ? 0.05 : -0.05;
  const BrokenFaces all = find_broken_faces(assembly);
  const BrokenFaces quick = find_broken_faces(assembly, known);
  CHECK(!all.pairs.empty());
  CHECK(quick.faces == all.faces);
  CHECK(quick.pairs == all.pairs);
  CHECK(quick.disjoint == all.disjoint);
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

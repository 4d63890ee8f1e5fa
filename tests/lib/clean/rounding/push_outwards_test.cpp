/// Vertices are pushed outside of all faces around them, by a step of the grid.
#include "clean/rounding/push_outwards.h"

#include <doctest/doctest.h>

#include "helpers/assembly_of.h"
#include "helpers/mesh_facts.h"
#include "helpers/shapes.h"

namespace transformesh {

TEST_CASE("a cube grows by its spacings on all sides") {
  const Mesh cube = test::moved(test::cube(), {1, 1, 1});
  Assembly assembly = test::assembly_of(cube);
  assembly.face_is_new.assign(12, 0);
  const double share = 1024;
  push_outwards(assembly, test::all_faces(cube), {share, false}, {Scalar::float32});
  for (Index v = 0; v < 8; ++v) {
    const Vec3 out = assembly.mesh.positions[v] - cube.positions[v];
    const Vec3 from_middle = cube.positions[v] - Vec3(1.5, 1.5, 1.5);
    const double spacing = share * spacing_around(cube.positions[v], Scalar::float32);
    for (int i = 0; i < 3; ++i) CHECK(out[i] == (from_middle[i] > 0 ? spacing : -spacing));
  }
  CHECK(assembly.face_is_new[0] == 1);
}

TEST_CASE("input vertices stay unless the rule moves them") {
  const Mesh cube = test::moved(test::cube(), {1, 1, 1});
  Assembly assembly = test::assembly_of(cube);
  assembly.vertex_is_new.assign(8, 0);
  CHECK(push_outwards(assembly, test::all_faces(cube), {1, false}, {Scalar::float64}).spacings ==
        0);
  CHECK(assembly.mesh.positions == cube.positions);
  CHECK(push_outwards(assembly, test::all_faces(cube), {1, true}, {Scalar::float64}).spacings >
        0.9);
  CHECK(test::signed_volume(assembly.mesh) > 1);
}

TEST_CASE("a vertex that no direction leads outside stays") {
  // Both sides of one triangle: what is outside of one is inside of the other.
  Mesh flat;
  flat.positions = {{1, 1, 1}, {2, 1, 1}, {1, 2, 1}};
  flat.faces = {{0, 1, 2}, {0, 2, 1}};
  Assembly assembly = test::assembly_of(flat);
  push_outwards(assembly, {0, 1}, {1, true}, {Scalar::float64});
  CHECK(assembly.mesh.positions == flat.positions);
}

}  // namespace transformesh

#include "clean/rounding/unsplittable_edges.h"

#include <doctest/doctest.h>

#include "clean/rounding/broken_faces.h"
#include "helpers/shapes.h"
#include "transformesh/check_mesh.h"
#include "transformesh/clean.h"
#include "transformesh/measure.h"

using namespace transformesh;

namespace {

constexpr double spacing = 0x1p-52;  ///< spacing of doubles from 1 to 2

/// Four boxes: two touch along a vertical edge, one is below and one above its middle. The gap
/// between the last two leaves two slits that meet along an edge of that length.
Mesh crossing_slits(double gap) {
  Mesh mesh =
      test::joined(test::cuboid({0, 0, 0.5}, {1, 1, 1.5}), test::cuboid({1, 1, 0.5}, {2, 2, 1.5}));
  mesh = test::joined(mesh, test::cuboid({0.5, 0.5, 0}, {1.5, 1.5, 1}));
  return test::joined(mesh, test::cuboid({0.5, 0.5, 1 + gap}, {1.5, 1.5, 2}));
}

/// Two tetrahedra with a common edge. Both ends of the edge may be new vertices.
Assembly two_at_an_edge(double length, bool first_is_new, bool second_is_new) {
  Assembly assembly;
  assembly.mesh.positions = {{1, 1, 1}, {1, 1, 1 + length}, {2, 1, 1},
                             {1, 2, 1}, {0, 1, 1},          {1, 0, 1}};
  assembly.mesh.faces = {{0, 2, 3}, {1, 3, 2}, {0, 3, 1}, {0, 1, 2},
                         {0, 4, 5}, {1, 5, 4}, {0, 5, 1}, {0, 1, 4}};
  assembly.vertex_is_new.assign(6, 0);
  assembly.vertex_is_new[0] = first_is_new ? 1 : 0;
  assembly.vertex_is_new[1] = second_is_new ? 1 : 0;
  assembly.face_is_new.assign(8, 0);
  return assembly;
}

}  // namespace

TEST_CASE("slits that meet along one spacing are cleaned") {
  for (const double spacings : {0, 1, 2, 3, 8, 1 << 20}) {
    CAPTURE(spacings);
    const CleanResult result = clean(crossing_slits(spacings * spacing));
    const MeshCheck check = check_mesh(result.mesh, {.closed = true, .intersections = true});
    CHECK(check.problems.empty());
    CHECK(volume(result.mesh) == doctest::Approx(3.5));
    CHECK(result.rounding_spacings < 3);
  }
}

TEST_CASE("an edge is contracted if its middle is one of its ends") {
  Displacement moved;
  Assembly assembly = two_at_an_edge(spacing, false, true);
  CHECK(contract_unsplittable_edges(assembly, false, Scalar::float64, moved));
  CHECK(assembly.mesh.positions[1] == assembly.mesh.positions[0]);
  CHECK(assembly.mesh.positions[0] == Vec3(1, 1, 1));
  CHECK(moved.length == spacing);
  CHECK(moved.spacings == 1);
  CHECK(assembly.face_is_new == std::vector<char>(8, 1));

  assembly = two_at_an_edge(2 * spacing, false, true);
  CHECK(!contract_unsplittable_edges(assembly, true, Scalar::float64, moved));
  CHECK(contract_unsplittable_edges(assembly, true, Scalar::float32, moved));
}

TEST_CASE("vertices of the input stay where new ones can move, or until they may") {
  Displacement moved;
  Assembly assembly = two_at_an_edge(spacing, true, false);
  CHECK(contract_unsplittable_edges(assembly, false, Scalar::float64, moved));
  CHECK(assembly.mesh.positions[0] == Vec3(1, 1, 1 + spacing));

  assembly = two_at_an_edge(spacing, false, false);
  CHECK(!contract_unsplittable_edges(assembly, false, Scalar::float64, moved));
  CHECK(contract_unsplittable_edges(assembly, true, Scalar::float64, moved));
  CHECK(drop_collapsed_faces(assembly));
}

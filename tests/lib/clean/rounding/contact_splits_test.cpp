/// Faces that intersect by a few spacings come to share corners; those that intersect deeply stay.
#include "clean/rounding/contact_splits.h"

#include <doctest/doctest.h>

#include "clean/rounding/broken_faces.h"
#include "helpers/assembly_of.h"
#include "helpers/mesh_facts.h"
#include "helpers/shapes.h"

namespace transformesh {
namespace {

/// A tetrahedron that points down into the top of a cube, by a depth.
Mesh pricked_cube(double depth) {
  Mesh needle = test::tetrahedron();
  needle.positions = {{0.55, 0.4, 1 - depth}, {0.2, 0.2, 2}, {0.2, 0.7, 2}, {0.8, 0.3, 2}};
  if (test::signed_volume(needle) < 0) needle = test::reversed(needle);
  return test::joined(test::cube(), needle);
}

Displacement split(Assembly& assembly) {
  return split_at_contacts(assembly, find_broken_faces(assembly).intersections, 4,
                           {Scalar::float64});
}

}  // namespace

TEST_CASE("a corner that is a few spacings deep in a face splits it") {
  const Mesh before = pricked_cube(2 * 0x1p-52);
  Assembly assembly = test::assembly_of(before);
  const Displacement moved = split(assembly);
  CHECK(moved.spacings > 0);
  CHECK(assembly.mesh.faces.size() == before.faces.size() + 2);
  CHECK(assembly.mesh.positions == before.positions);
  CHECK(test::count(assembly.mesh).is_closed_and_oriented);
  CHECK(assembly.source_face.size() == assembly.mesh.faces.size());
}

TEST_CASE("a corner that is deep in a face does not") {
  Assembly assembly = test::assembly_of(pricked_cube(0.1));
  CHECK(split(assembly).spacings == 0);
  CHECK(assembly.mesh.faces.size() == 16);
}

TEST_CASE("edges that pass each other closely are both split at one position") {
  // Two roofs, the lower one upside down; their ridges intersect at a right angle.
  Mesh lower = test::tetrahedron(), upper = lower;
  lower.positions = {{-1, 0, 0}, {1, 0, 0}, {0, -0.5, -1}, {0, 0.5, -1}};
  upper.positions = {{0, -1, -0x1p-53}, {0, 1, -0x1p-53}, {-0.5, 0, 1}, {0.5, 0, 1}};
  if (test::signed_volume(lower) < 0) lower = test::reversed(lower);
  if (test::signed_volume(upper) < 0) upper = test::reversed(upper);
  // Away from the origin, where numbers have spacings.
  const Vec3 away(4, 4, 0);
  Mesh both = test::moved(test::joined(lower, upper), away);
  for (Vec3& p : both.positions) p.z() += 1;
  for (Index v = 4; v < 6; ++v) both.positions[v].z() = 1 - 0x1p-51;
  Assembly assembly = test::assembly_of(both);
  CHECK(split(assembly).spacings > 0);
  CHECK(assembly.mesh.positions.size() == 9);
  CHECK(assembly.mesh.faces.size() == 12);
  CHECK(test::count(assembly.mesh).is_closed_and_oriented);
}

}  // namespace transformesh

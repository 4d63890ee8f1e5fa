/// Grids are coarsened only at broken faces, and only vertices of these faces move to grid points.
#include "clean/rounding/vertex_grids.h"

#include <doctest/doctest.h>

#include "helpers/assembly_of.h"

using namespace transformesh;

namespace {

/// Two faces without a common vertex; all vertices are new.
Assembly two_faces(const Vec3& first) {
  Assembly assembly;
  assembly.mesh.positions = {first, {1, 0, 0}, {0, 1, 0}, {3, 0, 0}, {4, 1e-17, 0}, {3, 1, 0}};
  assembly.mesh.faces = {{0, 1, 2}, {3, 4, 5}};
  assembly.vertex_is_new.assign(6, 1);
  assembly.face_is_new.assign(2, 0);
  assembly.source_face = {0, 1};
  assembly.input_vertex.assign(6, no_index);
  return assembly;
}

}  // namespace

TEST_CASE("grid steps double at the corners of broken faces, and nowhere else") {
  const Assembly assembly = two_faces({1, 1e-17, -0x1.8p-53});
  VertexGrids grids(assembly, Scalar::float64);
  CHECK(grids.step(assembly.mesh, 0) == 0x1p-53);
  grids.coarsen(assembly.mesh, {0});
  grids.coarsen(assembly.mesh, {0});
  CHECK(grids.step(assembly.mesh, 0) == 0x1p-51);
  CHECK(grids.step(assembly.mesh, 3) == 0x1p-52);
  CHECK(grids.levels_of_faces(assembly.mesh) == std::vector<std::uint8_t>{2, 0});
  CHECK(grids.largest_level() == 2);
}

TEST_CASE("vertices move to the nearest point of their own grids where these are coarser") {
  Assembly assembly = two_faces({1, 1e-17, -0x1.8p-53});
  VertexGrids grids(assembly, Scalar::float64);
  Displacement moved;
  CHECK(!grids.snap(assembly, {0, 1}, true, moved));
  grids.coarsen(assembly.mesh, {0});
  CHECK(grids.snap(assembly, {0, 1}, true, moved));
  CHECK(assembly.mesh.positions[0] == Vec3(1, 0, -0x1p-52));
  CHECK(assembly.mesh.positions[4] == Vec3(4, 1e-17, 0));
  CHECK(assembly.face_is_new == std::vector<char>{1, 0});
  CHECK(moved.spacings > 0);
  CHECK(moved.spacings < 0.87);
  CHECK(!grids.snap(assembly, {0, 1}, true, moved));
}

TEST_CASE("vertices of the input move only if they may, and floats have grids of their own") {
  Assembly assembly = two_faces({1, 1e-9, 0x1p-23});
  assembly.vertex_is_new[0] = 0;
  VertexGrids grids(assembly, Scalar::float32);
  grids.coarsen(assembly.mesh, {0});
  Displacement moved;
  CHECK(!grids.snap(assembly, {0}, false, moved));
  CHECK(grids.snap(assembly, {0}, true, moved));
  CHECK(assembly.mesh.positions[0] == Vec3(1, 0, 0x1p-23));
}

TEST_CASE("after cleaning, vertices keep their grids, and new ones take those of their sources") {
  const Assembly before = two_faces({1, 0, 0.5});
  VertexGrids grids(before, Scalar::float64);
  grids.coarsen(before.mesh, {1});
  Assembly after = two_faces({1, 0, 0.5});
  after.source_face = {1, 1};
  after.input_vertex = {0, no_index, 5, 3, 4, 5};
  grids.inherit(before.mesh, after);
  CHECK(grids.step(after.mesh, 0) == 0x1p-53);
  CHECK(grids.step(after.mesh, 1) == 0x1p-52);
  CHECK(grids.step(after.mesh, 2) == 0x1p-52);
}

/// Every vertex keeps the digits that count at its largest coordinate, and only these.
#include "clean/rounding/vertex_grids.h"

#include <doctest/doctest.h>

namespace transformesh {

TEST_CASE("vertices take the nearest point of their own grids") {
  Mesh mesh;
  mesh.positions = {{1, 1e-17, -0x1.8p-53}, {1e150, 1e80, 3e-150}, {0.1, 0.2, 0.3}, {0, 0, 0}};
  const std::vector<Vec3> before = mesh.positions;
  const Displacement moved = snap_to_vertex_grids(mesh, Scalar::float64, 1);
  CHECK(mesh.positions[0] == Vec3(1, 0, -0x1p-52));
  CHECK(mesh.positions[1] == Vec3(1e150, 0, 0));
  CHECK((mesh.positions[2] - before[2]).norm() < 0x1p-54);
  CHECK(mesh.positions[3] == Vec3(0, 0, 0));
  CHECK(moved.spacings > 0);
  CHECK(moved.spacings < 0.87);
  CHECK(snap_to_vertex_grids(mesh, Scalar::float64, 1).spacings == 0);

  mesh.positions = {{1, 1e-9, 0x1p-23}};
  snap_to_vertex_grids(mesh, Scalar::float32, 1);
  CHECK(mesh.positions[0] == Vec3(1, 0, 0x1p-23));
}

TEST_CASE("a grid may be coarser than the numbers") {
  Mesh mesh;
  mesh.positions = {{1 + 0x1p-50, 0x1.3p-47, 0x1p-49}};
  const Displacement moved = snap_to_vertex_grids(mesh, Scalar::float64, 32);
  CHECK(mesh.positions[0] == Vec3(1, 0x1p-47, 0));
  CHECK(moved.spacings > 8);
  CHECK(moved.spacings < 0.87 * 32);
  CHECK(snap_to_vertex_grids(mesh, Scalar::float64, 32).spacings == 0);
}

}  // namespace transformesh

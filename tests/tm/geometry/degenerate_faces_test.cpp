#include "tm/geometry/degenerate_faces.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"

using namespace transformesh;

TEST_CASE("faces without area are found exactly") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {3, 3, 3}, {3, 3, 3 + 0x1p-51}};
  mesh.faces = {{0, 1, 2}, {0, 1, 4}, {0, 2, 3}, {0, 2, 4}, {1, 1, 4}, {2, 3, 3}};
  CHECK(degenerate_faces(mesh) == std::vector<Index>{0, 2, 4, 5});

  // Areas far below what doubles can hold are areas still.
  mesh.positions = {{0, 0, 0}, {1e-200, 0, 0}, {0, 1e-200, 0}};
  mesh.faces = {{0, 1, 2}};
  CHECK(degenerate_faces(mesh).empty());
  CHECK(degenerate_faces(test::icosphere(3)).empty());
  CHECK(degenerate_faces(Mesh{}).empty());
}

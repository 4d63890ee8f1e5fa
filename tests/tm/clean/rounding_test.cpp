/// Merging of new vertices: what is at one position stays at one position.
#include "tm/clean/rounding.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"

namespace transformesh {
namespace {

/// Two faces that meet in a point of which each has its own copy, and a third beside it.
Assembly three_faces() {
  Assembly assembly;
  assembly.mesh.positions = {Vec3(0, 0, 0),   Vec3(1, 0, 0),  Vec3(0, 1, 0),
                             Vec3(0, 0, 0),   Vec3(-1, 0, 0), Vec3(0, -1, 0),
                             Vec3(0.1, 0, 0), Vec3(0, 0, 1),  Vec3(0, 1, 1)};
  assembly.mesh.faces = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
  assembly.vertex_is_new.assign(9, 1);
  assembly.vertex_is_new[6] = 0;
  assembly.face_is_new.assign(3, 1);
  assembly.source_face = {0, 1, 2};
  return assembly;
}

}  // namespace

TEST_CASE("merging moves all vertices at a position, though only one belongs to the faces named") {
  Assembly assembly = three_faces();
  merge_close_vertices(assembly, {0, 2}, 0.2);
  CHECK(assembly.mesh.positions[0] == Vec3(0.1, 0, 0));
  CHECK(assembly.mesh.positions[3] == Vec3(0.1, 0, 0));
  CHECK(assembly.mesh.positions[6] == Vec3(0.1, 0, 0));
  CHECK(assembly.mesh.positions[1] == Vec3(1, 0, 0));
}

TEST_CASE("new vertices at the place of an input vertex stay there") {
  Assembly assembly = three_faces();
  assembly.vertex_is_new[3] = 0;
  merge_close_vertices(assembly, {0}, 0.2);
  CHECK(assembly.mesh.positions[0] == Vec3(0, 0, 0));
  CHECK(assembly.mesh.positions[3] == Vec3(0, 0, 0));
}

TEST_CASE("the faces around faces are those at their corners") {
  const Mesh cube = test::cube();
  const std::vector<Index> around = with_faces_around(cube, {0});
  std::size_t expected = 0;
  for (const Face& f : cube.faces) {
    bool touches = false;
    for (const Index v : f)
      touches |= std::count(cube.faces[0].begin(), cube.faces[0].end(), v) > 0;
    expected += touches ? 1 : 0;
  }
  CHECK(around.size() == expected);
  CHECK(expected < cube.faces.size());
  CHECK(with_faces_around(cube, {}).empty());
}

}  // namespace transformesh

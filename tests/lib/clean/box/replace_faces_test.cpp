#include "clean/box/replace_faces.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"

using namespace transformesh;

TEST_CASE("pieces of a cut face are appended and share its columns") {
  const Mesh input = test::tetrahedron();
  // Face 1 has corners 0, 1, 3. It is split from corner 0 to the middle of the opposite edge.
  CleanedFaces cleaned;
  cleaned.mesh.positions = {
      input.positions[3], {.5, 0, .5}, input.positions[0], input.positions[1]};
  cleaned.mesh.faces = {{2, 3, 1}, {2, 1, 0}};
  cleaned.source_face = {1, 1};
  CHECK(find_uncut(input, cleaned) == std::vector<bool>{false, false});
  const Mesh result = replace_faces(input, {false, true, false, false}, cleaned);
  CHECK(result.positions.size() == 5);
  CHECK(result.faces == std::vector<Face>{{0, 2, 1}, {0, 3, 2}, {1, 2, 3}, {0, 1, 4}, {0, 4, 3}});
}

TEST_CASE("removed faces remove their vertices, and uncut faces stay in place") {
  const Mesh input = test::joined(test::tetrahedron(), test::moved(test::tetrahedron(), {5, 0, 0}));
  CleanedFaces cleaned;
  cleaned.mesh = test::moved(test::tetrahedron(), {5, 0, 0});
  cleaned.source_face = {4, 5, 6, 7};
  const Mesh result = replace_faces(input, std::vector<bool>(8, true), cleaned);
  CHECK(result.positions == cleaned.mesh.positions);
  CHECK(result.faces == cleaned.mesh.faces);
}

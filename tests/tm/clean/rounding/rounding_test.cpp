/// Merging of new vertices: what is at one position stays at one position.
#include "tm/clean/rounding/rounding.h"

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

/// Faces each with a corner of their own near the origin, in a row a spacing apart; all is new.
Assembly cluster_of_faces(int count) {
  Assembly assembly;
  for (int i = 0; i < count; ++i) {
    const double angle = 6.28 * i / count;
    assembly.mesh.positions.insert(
        assembly.mesh.positions.end(),
        {Vec3(i * 0x1p-24, 0, 0), Vec3(std::cos(angle), std::sin(angle), 0.5),
         Vec3(std::cos(angle), std::sin(angle), -0.5)});
    const auto first = static_cast<Index>(3 * i);
    assembly.mesh.faces.push_back({first, first + 1, first + 2});
    assembly.source_face.push_back(static_cast<Index>(i));
  }
  assembly.vertex_is_new.assign(assembly.mesh.positions.size(), 1);
  assembly.face_is_new.assign(assembly.mesh.faces.size(), 1);
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

TEST_CASE("copies of a vertex merge with the same one, though a nearer one comes between them") {
  Assembly assembly;
  assembly.mesh.positions = {Vec3(0, 0, 0),    Vec3(1, 1, 0), Vec3(0, 1, 1),   // a vertex,
                             Vec3(0.19, 0, 0), Vec3(1, 2, 0), Vec3(0, 2, 1),   // a copy,
                             Vec3(0.21, 0, 0), Vec3(1, 3, 0), Vec3(0, 3, 1),   // what is nearer
                             Vec3(0.19, 0, 0), Vec3(1, 4, 0), Vec3(0, 4, 1)};  // and the other
  assembly.mesh.faces = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11}};
  assembly.vertex_is_new.assign(12, 1);
  assembly.face_is_new.assign(4, 1);
  merge_close_vertices(assembly, {0, 1, 2, 3}, 0.2);
  CHECK(assembly.mesh.positions[3] == assembly.mesh.positions[9]);
}

TEST_CASE("new vertices at the place of an input vertex stay there") {
  Assembly assembly = three_faces();
  assembly.vertex_is_new[3] = 0;
  merge_close_vertices(assembly, {0}, 0.2);
  CHECK(assembly.mesh.positions[0] == Vec3(0, 0, 0));
  CHECK(assembly.mesh.positions[3] == Vec3(0, 0, 0));
}

TEST_CASE("new vertices of a cluster go to its input vertex, whatever is at the same position") {
  Assembly assembly = cluster_of_faces(40);
  const Vec3 input = assembly.mesh.positions[0];
  assembly.vertex_is_new[0] = 0;
  assembly.mesh.positions[3] = input;  // a copy of it
  merge_clusters(assembly, {5}, Scalar::float32);
  for (std::size_t v = 0; v < assembly.mesh.positions.size(); ++v) {
    if (v % 3 == 0)
      CHECK(assembly.mesh.positions[v] == input);
    else
      CHECK(assembly.mesh.positions[v].norm() > 0.5);
  }
}

TEST_CASE("a cluster without an input vertex goes to the one in its middle; a smaller one stays") {
  Assembly assembly = cluster_of_faces(41);
  merge_clusters(assembly, {5}, Scalar::float32);
  for (std::size_t v = 0; v < assembly.mesh.positions.size(); v += 3)
    CHECK(assembly.mesh.positions[v] == Vec3(20 * 0x1p-24, 0, 0));
  Assembly few = cluster_of_faces(29);
  const std::vector<Vec3> before = few.mesh.positions;
  merge_clusters(few, {5}, Scalar::float32);
  CHECK(few.mesh.positions == before);
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

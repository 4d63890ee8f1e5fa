#include "clean/box/box_submesh.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "helpers/shapes.h"

using namespace transformesh;

TEST_CASE("a box has its lower sides and not its upper ones") {
  const Mesh cube = test::cube();
  std::vector<int> owners(cube.faces.size(), 0);
  for (int i = 0; i < 8; ++i) {
    const Vec3 low(i & 1, i >> 1 & 1, i >> 2 & 1);
    const std::vector<bool> own = faces_of_box(cube, {low, low + Vec3::Ones()});
    for (std::size_t f = 0; f < own.size(); ++f) owners[f] += own[f] ? 1 : 0;
  }
  CHECK(std::all_of(owners.begin(), owners.end(), [](int count) { return count == 1; }));
}

TEST_CASE("faces near a box are those whose bounding boxes meet it") {
  const Mesh ball = test::icosphere(3);
  const Box box(Vec3::Constant(.5), Vec3::Ones());
  const std::vector<bool> near = faces_near(ball, box);
  for (Index f = 0; f < ball.faces.size(); ++f) {
    bool reaches = true;
    for (int i = 0; i < 3; ++i) {
      double most = -9;
      for (const Index v : ball.faces[f]) most = std::max(most, ball.positions[v][i]);
      reaches &= most >= .5;
    }
    CHECK(near[f] == reaches);
  }
}

TEST_CASE("a part keeps order and columns, and the first vertex of every place comes along") {
  Mesh mesh = test::joined(test::cube(), test::cube());
  mesh.vertex_columns.get("id", Scalar::int32, 16).values = {0, 1, 2,  3,  4,  5,  6,  7,
                                                             8, 9, 10, 11, 12, 13, 14, 15};
  std::vector<bool> second(24, false);
  std::fill(second.begin() + 12, second.end(), true);
  const BoxSubmesh part = take_submesh(mesh, second);
  CHECK(part.face_of.front() == 12);
  CHECK(part.mesh.positions.size() == 16);
  CHECK(part.mesh.faces.front() == mesh.faces[12]);
  CHECK(part.mesh.vertex_columns.find("id")->values[9] == 9);
}

TEST_CASE("a part is closed if every edge is traversed equally often both ways") {
  Mesh mesh = test::joined(test::icosphere(2), test::cuboid({0, 0, 0}, {3, 3, 3}));
  CHECK(face_sums(mesh).is_closed());
  std::swap(mesh.faces[7][0], mesh.faces[7][1]);
  CHECK(!face_sums(mesh).is_closed());
  std::swap(mesh.faces[7][0], mesh.faces[7][1]);
  mesh.faces.erase(mesh.faces.begin() + 3);
  CHECK(!face_sums(mesh).is_closed());
}

TEST_CASE("the hash of faces depends on every corner and on the order, not on indices") {
  const Mesh ball = test::icosphere(1);
  const std::uint64_t hash = face_sums(ball).hash();
  CHECK(face_sums(test::soup_of(ball)).hash() == hash);
  Mesh changed = ball;
  std::swap(changed.faces[3], changed.faces[4]);
  CHECK(face_sums(changed).hash() != hash);
  changed = ball;
  changed.positions[5].z() = std::nextafter(changed.positions[5].z(), 9);
  CHECK(face_sums(changed).hash() != hash);
}

TEST_CASE("a margin is 64 spacings of the coordinates as they are written") {
  const Box box(Vec3(-1, -4, 0), Vec3(3, 1, 1));
  CHECK(with_margin(box, Scalar::float64).max().x() == 3 + 0x1p-44);
  CHECK(with_margin(box, Scalar::float32).min().y() == -4 - 0x1p-15);
}

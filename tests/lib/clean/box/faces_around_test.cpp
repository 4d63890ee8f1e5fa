#include "clean/box/faces_around.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "helpers/shapes.h"

using namespace transformesh;

namespace {

bool share_position(const Mesh& mesh, Index f, Index g) {
  for (const Index v : mesh.faces[f])
    for (const Index w : mesh.faces[g])
      if (mesh.positions[v] == mesh.positions[w]) return true;
  return false;
}

}  // namespace

TEST_CASE("faces around others are all that touch them, and few of the rest") {
  const Mesh ball = test::icosphere(4);
  CellSize size;
  for (Index f = 0; f < ball.faces.size(); ++f) size.add(triangle_of(ball, f));
  std::vector<bool> some(ball.faces.size(), false);
  for (Index f = 0; f < 200; ++f) some[f] = true;
  const std::vector<bool> around =
      FacesAround(ball, some, CellGrid(size.size()), Scalar::float64).next();
  for (Index f = 0; f < ball.faces.size(); ++f) {
    bool touches = false;
    for (Index g = 0; g < 200 && !touches; ++g) touches = share_position(ball, f, g);
    if (touches) CHECK(around[f]);
  }
  CHECK(std::count(around.begin(), around.end(), true) < 600);
}

TEST_CASE("a face in the cell of another one is around it, at any distance in the cell") {
  Mesh mesh;
  for (const double z : {0.9, 0.1, -2.5})
    for (const Vec3& p : {Vec3(0.4, 0.4, z), Vec3(0.6, 0.4, z), Vec3(0.4, 0.6, z)})
      mesh.positions.push_back(p);
  mesh.faces = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
  for (const bool is_first : {false, true}) {
    const FacesAround around(mesh, {is_first, !is_first, false}, CellGrid(1), Scalar::float64);
    CHECK(around.next() == std::vector<bool>{true, true, false});
  }
}

TEST_CASE("a cell may be within the margins of two faces, which grow with the coordinates") {
  // The margin of floats at 1000 is 0.0039. The faces are on both sides of the cell from 1000 to
  // 1000.125, at a distance of 0.0035.
  Mesh mesh;
  for (const double z : {999.9965, 1000.1285})
    for (const Vec3& p : {Vec3(0.04, 0.04, z), Vec3(0.06, 0.04, z), Vec3(0.04, 0.06, z)})
      mesh.positions.push_back(p);
  mesh.faces = {{0, 1, 2}, {3, 4, 5}};
  const CellGrid grid(0.125);
  CHECK(FacesAround(mesh, {true, false}, grid, Scalar::float32).next() == std::vector{true, true});
  CHECK(FacesAround(mesh, {true, false}, grid, Scalar::float64).next() == std::vector{true, false});
}

TEST_CASE("a needle beyond the faces adds only faces along it") {
  Mesh mesh = test::icosphere(4);
  const auto v = static_cast<Index>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {{-1, -1, -1}, {1, 1, 1}, {1, 1, 1.01}});
  mesh.faces.push_back({v, v + 1, v + 2});
  std::vector<bool> needle(mesh.faces.size(), false);
  needle.back() = true;
  const std::vector<bool> around = FacesAround(mesh, needle, CellGrid(.05), Scalar::float64).next();
  const auto near = std::count(around.begin(), around.end(), true);
  CHECK(near > 2);
  CHECK(near < 100);
}

TEST_CASE("rings found one by one equal those found at once") {
  const Mesh ball = test::icosphere(4);
  std::vector<bool> some(ball.faces.size(), false);
  for (Index f = 0; f < 20; ++f) some[f] = true;
  const CellGrid grid(.03);
  FacesAround faces(ball, some, grid, Scalar::float64);
  for (int ring = 0; ring < 3; ++ring) {
    const std::vector<bool> next = faces.next();
    CHECK(next == FacesAround(ball, faces.faces(), grid, Scalar::float64).next());
    CHECK(next != faces.faces());
    faces.grow();
    CHECK(next == faces.faces());
  }
}

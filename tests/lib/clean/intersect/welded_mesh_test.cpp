#include "clean/intersect/welded_mesh.h"

#include <doctest/doctest.h>

#include "helpers/random.h"
#include "helpers/shapes.h"

using namespace transformesh;

TEST_CASE("equal positions are merged, in the order of their first vertex") {
  test::Random random(2);
  Mesh mesh;
  for (int i = 0; i < 500; ++i) {
    const auto lattice = [&] { return static_cast<double>(random.below(5)) - 2; };
    const double x = lattice(), y = lattice();
    mesh.positions.emplace_back(x, y, -lattice());
  }
  const WeldedMesh welded = weld(mesh);
  REQUIRE(welded.point_of.size() == mesh.positions.size());
  std::size_t points = 0;
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    const auto first = std::find(mesh.positions.begin(), mesh.positions.end(), mesh.positions[v]);
    const auto expected = static_cast<Index>(first - mesh.positions.begin());
    CHECK(welded.vertex_of[welded.point_of[v]] == expected);
    CHECK(welded.points[welded.point_of[v]] == mesh.positions[v]);
    if (expected == v) CHECK(welded.point_of[v] == points++);
  }
  CHECK(welded.points.size() == points);
  CHECK(points < 126);
}

TEST_CASE("zero is one coordinate, whatever its sign") {
  Mesh mesh;
  mesh.positions = {{0.0, 0, 1}, {-0.0, -0.0, 1}};
  CHECK(weld(mesh).points.size() == 1);
  CHECK(!std::signbit(weld(mesh).points[0].x()));
}

TEST_CASE("faces without area are left out, exactly") {
  Mesh mesh = test::soup_of(test::cube());
  mesh.positions.insert(mesh.positions.end(), {{0.1, 0.1, 0.1}, {0.3, 0.3, 0.3}, {0.7, 0.7, 0.7}});
  mesh.faces.insert(mesh.faces.begin(), {{36, 37, 38}, {36, 36, 37}, {0, 1, 0}});
  const double third = std::nextafter(0.3, 1);
  mesh.positions.insert(mesh.positions.end(), {{0, 0, 0}, {0.3, 0.3, third}, {0.6, 0.6, 0.6}});
  mesh.faces.push_back({39, 40, 41});
  const WeldedMesh welded = weld(mesh);
  CHECK(welded.faces.size() == 12 + 1);
  CHECK(welded.face_of.front() == 3);
  CHECK(welded.face_of.back() == 15);
  CHECK(std::is_sorted(welded.face_of.begin(), welded.face_of.end()));
  for (std::size_t f = 0; f < welded.faces.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& corner = mesh.positions[mesh.faces[welded.face_of[f]][i]];
      CHECK(welded.triangle(static_cast<Index>(f))[i] == corner);
    }
  }
}

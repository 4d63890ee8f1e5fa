/// Winding numbers by rays, compared with sums of solid angles, and with closed forms for rays that
/// graze edges.
#include "clean/exterior/ray_cast_front_winding.h"

#include <doctest/doctest.h>

#include "helpers/arrangement_facts.h"

using namespace transformesh;

namespace {

/// The surface of a cube about the origin, cut into n * n unit squares on each side.
void add_lattice_cube(Mesh& mesh, int n) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      const Vec3 u = Vec3::Unit((axis + 1) % 3), v = Vec3::Unit((axis + 2) % 3);
      for (int i = 0; i < n * n; ++i) {
        const Vec3 shift = (i % n) * u + (i / n) * v;
        const Vec3 corner = n / 2.0 * (side * Vec3::Unit(axis) - u - v) + shift;
        const auto base = static_cast<Index>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(),
                              {corner, corner + u, corner + u + v, corner + v});
        const Index b = side > 0 ? base + 1 : base + 3, d = side > 0 ? base + 3 : base + 1;
        mesh.faces.insert(mesh.faces.end(), {{base, b, base + 2}, {base, base + 2, d}});
      }
    }
  }
}

}  // namespace

TEST_CASE("winding numbers in front of pieces agree with solid angles, with and without a tree") {
  std::size_t tested = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    CAPTURE(seed);
    const Mesh mesh = test::random_balls(seed, 4);
    const Arrangement arrangement = test::arranged(mesh);
    const RayCastFrontWinding few(*arrangement.welded, 1);
    const RayCastFrontWinding many(*arrangement.welded, 1000);
    for (const Piece& piece : arrangement.pieces) {
      const int winding = many.in_front_of(arrangement, piece);
      REQUIRE(few.in_front_of(arrangement, piece) == winding);
      const auto expected = test::winding_beside(mesh, test::corners_of(arrangement, piece), 1);
      if (!expected) continue;
      REQUIRE(winding == *expected);
      ++tested;
    }
  }
  CHECK(tested > 1500);
}

TEST_CASE("rays through corners of a lattice count correctly") {
  // The front of the k-th cube from outside lies inside of k other cubes.
  Mesh mesh;
  std::vector<int> expected;
  for (const int n : {5, 3, 1}) {
    const int around = (5 - n) / 2;
    add_lattice_cube(mesh, n);
    expected.resize(mesh.faces.size(), around);
  }
  const Arrangement arrangement = test::arranged(mesh);
  REQUIRE(arrangement.whole_pieces == mesh.faces.size());
  for (const std::size_t rays : {std::size_t{1}, mesh.faces.size()}) {
    const RayCastFrontWinding ray(*arrangement.welded, rays);
    for (std::size_t p = 0; p < expected.size(); ++p)
      CHECK(ray.in_front_of(arrangement, arrangement.pieces[p]) == expected[p]);
  }
}

TEST_CASE("open faces do not count") {
  const Mesh ball = test::icosphere(2);
  WeldedMesh welded = weld(test::joined(ball, test::scaled(test::icosphere(2), 2)));
  welded.open_component.assign(welded.faces.size(), no_index);
  std::fill(welded.open_component.begin() + ball.faces.size(), welded.open_component.end(), 0);
  const ExactGeometry geometry(welded.points, welded.faces);
  for (const std::size_t rays : {std::size_t{1}, welded.faces.size()}) {
    const RayCastFrontWinding ray(welded, rays);
    for (Index f = 0; f < welded.faces.size(); f += 7) {
      const auto& [a, b, c] = welded.faces[f];
      CHECK(ray.in_front_of({geometry.given(a), geometry.given(b), geometry.given(c)}, f) == 0);
    }
  }
}

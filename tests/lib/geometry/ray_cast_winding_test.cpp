#include "geometry/ray_cast_winding.h"

#include <doctest/doctest.h>

#include "geometry/solid_angle_winding.h"
#include "helpers/random.h"
#include "helpers/shape_options.h"
#include "helpers/shapes.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

/// Overlapping, nested, inverted and coincident parts, with winding numbers from -1 to 3.
Mesh nest() {
  Mesh mesh = joined(cuboid({-2, -2, -2}, {2, 2, 2}), cuboid({-1, -1, -1}, {1, 1, 1}));
  mesh = joined(mesh, cuboid({-1, -1, -1}, {1, 1, 1}));
  mesh = joined(mesh, reversed(cuboid({1, 1, 1}, {3, 3, 3})));
  return joined(mesh, moved(torus(1, 0.4, 24, 12), {0.3, 0.1, 0}));
}

}  // namespace

TEST_CASE("rays agree with solid angles") {
  const Mesh mesh = nest();
  const RayCastWinding by_rays(mesh);
  const SolidAngleWinding by_angles(mesh);
  test::Random random(3);
  int lowest = 0;
  int highest = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 point = random.point(-3.5, 3.5);
    const BoundedWindingNumber expected = by_angles(point);
    REQUIRE(expected.is_decided());
    REQUIRE(by_rays(point) == expected.rounded());
    lowest = std::min(lowest, expected.rounded());
    highest = std::max(highest, expected.rounded());
  }
  CHECK(lowest == -1);
  CHECK(highest >= 3);
}

TEST_CASE("rays through edges and corners count, and a point on the surface has no number") {
  const Mesh mesh = cuboid({0, 0, 0}, {4, 4, 4});
  const RayCastWinding winding(mesh);
  CHECK(winding({1, 2, 3}) == 1);
  // Rays from (1, 1, 3) along x and y meet diagonals of the sides.
  CHECK(winding({1, 1, 3}) == 1);
  CHECK(winding({1, 1, 5}) == 0);
  CHECK(!winding({1, 0, 2}));
  CHECK(!winding({0, 0, 0}));
  // Rays from (2, 2, 2) meet corners, edges or diagonals in all directions.
  ShapeOptions options = shape("box", 0, {"4", "4", "4"});
  options.edge = 2;
  options.center = {2, 2, 2};
  const Mesh grid = make_shape(options);
  const RayCastWinding of_grid(grid);
  CHECK(of_grid({2, 2, 2}) == 1);
  CHECK(of_grid({-2, 2, 2}) == 0);
  CHECK(of_grid({-2, 4, 2}) == 0);
  CHECK(of_grid({-2, 4, 4}) == 0);
  CHECK(of_grid({-2, 0, 0}) == 0);
  CHECK(!of_grid({2, 2, 4}));
  CHECK(!of_grid({1, 4, 4}));
  CHECK(RayCastWinding(Mesh())({1, 2, 3}) == 0);
}

TEST_CASE("rays are exact next to the surface and for extreme coordinates") {
  for (const double size : {1.0, 1e-30, 1e30}) {
    CAPTURE(size);
    const Mesh mesh = cuboid({-size, -size, -size}, {size, size, size});
    const RayCastWinding winding(mesh);
    const double inside = std::nextafter(size, 0);
    const double outside = std::nextafter(size, 2 * size);
    CHECK(winding({0.3 * size, 0.2 * size, inside}) == 1);
    CHECK(winding({0.3 * size, 0.2 * size, outside}) == 0);
    CHECK(winding.blocks({0.3 * size, 0.2 * size, inside}, {0.3 * size, 0.2 * size, outside}));
    CHECK(!winding.blocks({0.3 * size, 0.2 * size, inside}, {0.3 * size, 0.2 * size, 0}));
  }
}

TEST_CASE("faces without area are ignored") {
  Mesh mesh = cube();
  mesh.positions.insert(mesh.positions.end(), {{-1, 0.25, 0.5}, {3, 0.25, 0.5}});
  mesh.faces.push_back({8, 9, 8});
  mesh.faces.push_back({8, 8, 8});
  const RayCastWinding winding(mesh);
  CHECK(winding({0.5, 0.25, 0.5}) == 1);
  CHECK(winding({1.5, 0.25, 0.5}) == 0);
}

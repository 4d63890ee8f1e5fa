#include "evolution/miter.h"

#include <doctest/doctest.h>

#include <cmath>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "mesh/coordinate_spacing.h"
#include "transformesh/boolean.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"
#include "transformesh/offset.h"
#include "transformesh/select.h"

using namespace transformesh;
using doctest::Approx;

TEST_CASE("vertices move by the planes around them") {
  const std::vector<Vec3> directions = miter_directions(test::cube());
  for (const Vec3& way : directions) CHECK((way.cwiseAbs() - Vec3::Ones()).norm() < 1e-12);
  for (const Vec3& way : miter_directions(test::icosphere(4)))
    CHECK(way.norm() == Approx(1).epsilon(0.01));
}

TEST_CASE("a mitered offset of a cube is a cube, and of a thin one nothing") {
  for (const double distance : {0.5, -0.25}) {
    Mesh cube = test::cube();
    offset_mitered(cube, distance);
    const double side = 1 + 2 * distance;
    CHECK(volume(cube) == Approx(side * side * side));
    CHECK(cube.faces.size() == 12);
  }
  Mesh cube = test::cube();
  CHECK_THROWS_AS(offset_mitered(cube, -0.6), GoalError);
  CHECK_THROWS_AS(offset_mitered(cube, 0), UsageError);
  CHECK(volume(cube) == Approx(1));
}

TEST_CASE("the deviation says where planes miss the distance") {
  Mesh cube = test::cube();
  const MiterDeviation none = offset_mitered(cube, 0.5);
  CHECK(none.most < 1e-12);
  CHECK(!none.is_large);

  // A pyramid. At its tip, planes should move by 0.1; the movement of the tip is limited to 0.4.
  Mesh spike;
  spike.positions = {{-0.1, -0.1, 0}, {0.1, -0.1, 0}, {0.1, 0.1, 0}, {-0.1, 0.1, 0}, {0, 0, 2}};
  spike.faces = {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  const MiterDeviation cut = offset_mitered(spike, 0.1);
  CHECK(cut.is_large);
  CHECK(cut.at == Vec3(0, 0, 2));
  const double slope = 0.1 / std::hypot(0.1, 2);  // upward part of the normals of the sides
  CHECK(cut.most == Approx(0.1 - 0.4 * slope));
}

TEST_CASE("a part turned inside out is dropped, or its place is reported") {
  // A rod on a block becomes a thin rod if its sides change places.
  const Mesh block = test::cuboid({-2, -2, -2}, {2, 2, 2});
  const Mesh bar = test::cuboid({-0.5, -0.5, 1}, {0.5, 0.5, 6});
  Mesh rod = boolean(BooleanOperation::unite, {{&block}, {&bar}}).mesh;
  const MiterDeviation turned = offset_mitered(rod, -0.6);
  REQUIRE(turned.remains);
  CHECK(turned.remains->z() > 1.4);
  CHECK(turned.remains->head<2>().norm() < 0.2);
  CHECK_THROWS_AS(offset_mitered(rod, -2), GoalError);

  // The notch between two boxes that overlap in a unit cube becomes a cube with sides of 0.2.
  Mesh notched =
      test::joined(test::cuboid({1, 1, 1}, {4, 3, 3}), test::cuboid({3, 2, 2}, {5, 4, 4}));
  Mesh narrow = notched;
  CHECK(offset_mitered(notched, -0.6).remains);
  CHECK(!offset_mitered(narrow, -0.4).remains);

  // The walls of a sheet with a slanted border reach its surface. That is no fault.
  Mesh cut = test::cuboid({-1, -1, -1}, {1, 1, 1});
  cut_open(cut, {{0.3, 0.2, 1}, 0});
  CHECK(!thicken(cut, 0.2).remains);
  CHECK(cut.face_columns.columns.empty());

  // The sides of a square tube. Its bore is narrower than the thickness.
  Mesh tube;
  for (const double z : {0.0, 3.0})
    for (const Vec3& p : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0, -1, 0)})
      tube.positions.emplace_back(0.1 * p.x(), 0.1 * p.y(), z);
  for (Index i = 0; i < 4; ++i) {
    const Index next = (i + 1) % 4;
    tube.faces.insert(tube.faces.end(), {{i, next, next + 4}, {i, next + 4, i + 4}});
  }
  Mesh wide = tube;
  CHECK(thicken(tube, 0.3).remains);
  CHECK(!thicken(wide, 0.1).remains);
}

TEST_CASE("a thick sheet is closed and keeps its columns") {
  Mesh sheet;
  sheet.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  sheet.faces = {{0, 1, 2}, {0, 2, 3}};
  sheet.vertex_columns.get("x", Scalar::float64, 4).values = {0, 1, 1, 0};
  sheet.face_columns.get("label", Scalar::int32, 2).values = {7, 7};
  thicken(sheet, 0.5);
  CHECK(check_manifold(sheet).is_closed());
  CHECK(volume(sheet) == Approx(0.5));
  CHECK(bounding_box(sheet).min().z() == -0.25);
  for (std::size_t v = 0; v < sheet.positions.size(); ++v)
    CHECK(sheet.vertex_columns.find("x")->values[v] == sheet.positions[v].x());
  for (const double label : sheet.face_columns.find("label")->values) CHECK(label == 7);
  CHECK_THROWS_AS(thicken(sheet, 0.5), InputError);
  Mesh points;
  points.positions = {{0, 0, 0}};
  CHECK_THROWS_WITH_AS(thicken(points, 0.5), "the mesh has no faces, so it has no offset",
                       InputError);
}

TEST_CASE("a solid of a crumpled sheet has no self-intersection after it is written as float") {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    Mesh solid = test::grid(8);
    for (Vec3& position : solid.positions) position.z() = random.uniform(0, 0.4);
    round_positions(solid, Scalar::float32);
    thicken(solid, 0.1, Scalar::float32);
    CHECK(!rounded_mesh(solid, Scalar::float32));
    CHECK(check_manifold(solid).is_closed());
    CHECK(find_intersections(solid).empty());
  }
}

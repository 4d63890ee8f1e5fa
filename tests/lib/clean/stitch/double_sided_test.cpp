/// Double-sided shapes, compared with the shapes from which they were made.
#include "clean/stitch/double_sided.h"

#include <doctest/doctest.h>

#include <string>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "transformesh/clean.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"
#include "transformesh/stitch.h"

using namespace transformesh;

namespace {

/// Every face followed or preceded by its reverse, without common vertices.
Mesh double_sided(const Mesh& mesh, std::uint64_t seed) {
  test::Random random(seed);
  Mesh both;
  for (const Face& face : mesh.faces) {
    Face reverse{face[1], face[0], face[2]};
    const bool is_first = random.below(2) == 0;
    both.faces.push_back(is_first ? face : reverse);
    both.faces.push_back(is_first ? reverse : face);
  }
  both.positions = mesh.positions;
  return test::soup_of(both);
}

}  // namespace

TEST_CASE("one side of a double-sided solid is the solid") {
  const Mesh ball = test::icosphere(2);
  Mesh solids = test::joined(ball, test::reversed(test::moved(ball, {3, 0, 0})));
  Mesh mesh = double_sided(solids, 1);
  CHECK(count_double_sided(mesh) == mesh.faces.size());
  StitchOptions options;
  options.one_side = true;
  const StitchResult result = stitch(mesh, options);
  CHECK(result.dropped_reverses == solids.faces.size());
  CHECK(result.border_edges == 0);
  CHECK(result.misoriented_edges == 0);
  CHECK(mesh.faces.size() == solids.faces.size());
  for (const Component& component : connected_components(mesh).components)
    CHECK(component.volume == doctest::Approx(volume(ball)));
}

TEST_CASE("bodies that share faces become one, also if one is inside out") {
  const Mesh first = test::cube(), second = test::cuboid({1, 0, 0}, {2, 1, 1});
  for (const bool is_inward : {false, true}) {
    const Mesh both = test::joined(first, is_inward ? test::reversed(second) : second);
    Mesh mesh = test::soup_of(both);
    StitchOptions options;
    options.orient = options.drop_copies = options.outwards = true;
    const StitchResult result = stitch(mesh, options);
    CHECK(result.dropped_copies == (is_inward ? 4 : 0));
    CHECK(result.border_edges == 0);
    CHECK(volume(mesh) == doctest::Approx(2));
  }
  // A copied face of a single body is not a wall.
  Mesh mesh = first;
  mesh.faces.push_back(mesh.faces[3]);
  CHECK(drop_copies(mesh, true) == 1);
  CHECK(mesh.faces == first.faces);
  mesh = test::joined(first, first);
  for (Face& face : mesh.faces)
    for (Index& v : face) v %= 8;
  CHECK(drop_copies(mesh, true) == first.faces.size());
}

TEST_CASE("a double-sided model with cracks is recognized with their tolerance") {
  Mesh mesh = double_sided(test::icosphere(2), 1);
  CHECK(needs_one_side(mesh));
  test::Random random(2);
  for (Vec3& p : mesh.positions) p += random.point(-1e-7, 1e-7);
  CHECK_FALSE(needs_one_side(mesh));
  CHECK(needs_one_side(mesh, 1e-6));
}

TEST_CASE("a surface with one side only stays") {
  Mesh mesh = test::joined(test::icosphere(1), test::moved(test::icosphere(1), {3, 0, 0}));
  CHECK(count_double_sided(mesh) == 0);
  CHECK(drop_reverses(mesh) == 0);
  // A face and a copy in the same orientation do not count as double-sided.
  Mesh twice = test::joined(test::cube(), test::cube());
  CHECK(count_double_sided(twice) == 0);
  CHECK(turn_outwards(mesh) == 0);
}

TEST_CASE("one side must go where a part has no other faces, or where it leaves fewer borders") {
  const Mesh cube = test::cube();
  CHECK(!needs_one_side(cube));
  CHECK(needs_one_side(double_sided(cube, 3)));
  const Mesh touching = test::joined(cube, test::moved(cube, {1, 0, 0}));
  CHECK(count_double_sided(touching) == 4);
  CHECK(!needs_one_side(touching));
  CHECK(!needs_one_side(test::soup_of(touching)));
  CHECK(needs_one_side(test::joined(touching, test::moved(double_sided(cube, 3), {5, 0, 0}))));
  // A copy of each third face makes odd edges, but no second side.
  Mesh copied = touching;
  for (Index f = 0; f < touching.faces.size(); f += 3) copied.faces.push_back(touching.faces[f]);
  CHECK(!needs_one_side(copied));

  // Two sides of the cube's faces have a reverse.
  Mesh partly = cube;
  for (Index f = 0; f < 4; ++f)
    partly.faces.push_back({cube.faces[f][1], cube.faces[f][0], cube.faces[f][2]});
  CHECK(needs_one_side(partly));

  // A double-sided sheet at an edge of the cube.
  Mesh fin = cube;
  fin.positions.push_back({-1, -1, 0});
  const auto tip = static_cast<Index>(fin.positions.size() - 1);
  const Face& face = cube.faces[0];
  fin.faces.push_back({face[0], face[1], tip});
  fin.faces.push_back({face[1], face[0], tip});
  CHECK(!needs_one_side(fin));
}

TEST_CASE("cleaning says that a model is double-sided") {
  const Mesh mesh = double_sided(test::icosphere(1), 2);
  try {
    clean(mesh);
    FAIL("nothing is enclosed");
  } catch (const GoalError& error) {
    CHECK(error.kind() == ErrorKind::double_sided);
    CHECK(error.data().counts == std::vector<std::size_t>{160, 160});
    CHECK(
        std::string(error.what()).find("160 of 160 coincide with a face of opposite orientation") !=
        std::string::npos);
  }
}

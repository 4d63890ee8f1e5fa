#include "boolean/local_boolean.h"

#include <doctest/doctest.h>

#include "helpers/mesh_facts.h"
#include "helpers/random.h"
#include "helpers/shapes.h"
#include "transformesh/intersect.h"

using namespace transformesh;

namespace {

Mesh whole(BooleanOperation operation, const Mesh& solid, const Mesh& operand) {
  return boolean(operation, {{&solid}, {&operand}}).mesh;
}

/// A ball of many faces on a box of few faces.
Mesh statue() {
  const Mesh ball = test::icosphere(5);
  const Mesh base = test::cuboid(Vec3(-2, -2, -2), Vec3(2, 2, -0.5));
  return whole(BooleanOperation::unite, ball, base);
}

Mesh random_tool(test::Random& random) {
  const Vec3 at = random.point(-1.1, 1.1);
  if (random.below(2) == 0)
    return test::moved(test::scaled(test::icosphere(1), random.uniform(0.05, 0.15)), at);
  // Corners lie on a grid, so that tools touch each other and the base.
  const auto snapped = [](const Vec3& p) { return Vec3((8 * p).array().round().matrix() / 8); };
  return test::moved(test::scaled(test::cube(), 0.125), snapped(at));
}

}  // namespace

TEST_CASE("a chain of local operations equals operations on whole meshes") {
  test::Random random(7);
  Mesh expected = statue();
  EditedSolid solid(expected);
  std::size_t in_place = 0;
  for (int i = 0; i < 40; ++i) {
    CAPTURE(i);
    const auto operation =
        random.below(2) == 0 ? BooleanOperation::unite : BooleanOperation::subtract;
    const Mesh tool = random_tool(random);
    expected = whole(operation, expected, tool);
    if (combine_in_place(operation, solid, tool, {})) {
      ++in_place;
    } else {
      solid = EditedSolid(whole(operation, solid.take(), tool));
    }
  }
  CHECK(in_place >= 35);
  const Mesh result = solid.take();
  CHECK(test::signed_volume(result) ==
        doctest::Approx(test::signed_volume(expected)).epsilon(1e-12));
  CHECK(find_intersections(result).empty());
  const test::Count count = test::count(result);
  CHECK(count.is_closed_and_oriented);
  CHECK(count.is_manifold);
  CHECK(count.genera == test::count(expected).genera);
}

TEST_CASE("an operand that meets no face is inside or outside") {
  const Mesh ball = test::icosphere(4);
  const double volume = test::signed_volume(ball);
  const Mesh speck = test::scaled(test::cube(), 0.125);
  const auto changed = [&](BooleanOperation operation, const Vec3& at) {
    EditedSolid solid(ball);
    REQUIRE(combine_in_place(operation, solid, test::moved(speck, at), {}));
    return test::signed_volume(solid.take()) - volume;
  };
  const double size = std::pow(0.125, 3);
  CHECK(changed(BooleanOperation::unite, Vec3(0.1, 0.2, 0.3)) == 0);
  CHECK(changed(BooleanOperation::unite, Vec3(3, 2, 1)) == doctest::Approx(size));
  CHECK(changed(BooleanOperation::subtract, Vec3(0.1, 0.2, 0.3)) == doctest::Approx(-size));
  CHECK(changed(BooleanOperation::subtract, Vec3(3, 2, 1)) == 0);
}

TEST_CASE("a local operation that the part does not decide changes nothing") {
  const Mesh ball = test::icosphere(3);
  EditedSolid solid(ball);
  const auto is_done = [&](const Mesh& operand) {
    return combine_in_place(BooleanOperation::subtract, solid, operand, {}).has_value();
  };
  const Mesh tool = test::moved(test::scaled(test::cube(), 0.1), Vec3(0.95, 0, 0));
  CHECK_FALSE(is_done(ball));                  // the ball meets too much of the solid
  CHECK_FALSE(is_done(test::reversed(tool)));  // a tool that is inside out is no simple solid
  Mesh colored = tool;
  colored.face_columns.get("red", Scalar::uint8, colored.faces.size());
  CHECK_FALSE(is_done(colored));
  CHECK(solid.mesh().faces == ball.faces);
  CHECK(is_done(tool));
}

/// Records of steps, compared with the counts of the operations.
#include "repair/repair_steps.h"

#include <doctest/doctest.h>

#include <limits>

#include "helpers/mesh_facts.h"
#include "helpers/shapes.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

using namespace transformesh;

namespace {

const Progress silent;

RepairSteps steps_on(const Mesh& mesh) { return {mesh, Scalar::float64, silent}; }

}  // namespace

TEST_CASE("an operation that changes nothing is not recorded") {
  const Mesh ball = test::icosphere(2);
  RepairSteps steps = steps_on(ball);
  steps.stitch({.orient = true, .drop_copies = true, .outwards = true});
  steps.fill(true, 1);
  steps.clean();
  CHECK(steps.mesh().positions == ball.positions);
  CHECK(steps.mesh().faces == ball.faces);
  CHECK(steps.take_steps().empty());
}

TEST_CASE("joining is recorded with options, counts and the change of the volume") {
  const Mesh ball = test::icosphere(2);
  RepairSteps steps = steps_on(test::soup_of(ball));
  steps.stitch({.drop_copies = true});
  const std::vector<RepairStep> all = steps.take_steps();
  REQUIRE(all.size() == 1);
  CHECK(std::get<StitchOptions>(all[0].operation).drop_copies);
  CHECK(all[0].count == 3 * ball.faces.size() - ball.positions.size());
  CHECK(all[0].findings ==
        std::vector<std::string>{std::to_string(all[0].count) + " vertices joined with others"});
  CHECK(all[0].area_change == doctest::Approx(0));
  CHECK(all[0].volume_change == doctest::Approx(test::signed_volume(ball)));
  CHECK(all[0].lost_share == 0);
}

TEST_CASE("filling closes holes up to a diameter, and records the place") {
  Mesh ball = test::icosphere(2);
  const Face gone = ball.faces.back();
  ball.faces.pop_back();
  RepairSteps steps = steps_on(ball);
  steps.fill(false, 1e-3);
  CHECK(steps.mesh().faces.size() == ball.faces.size());
  steps.fill(false, std::numeric_limits<double>::infinity());
  const std::vector<RepairStep> all = steps.take_steps();
  REQUIRE(all.size() == 1);
  CHECK(all[0].findings == std::vector<std::string>{"1 hole filled"});
  const bool is_at_hole =
      std::ranges::any_of(gone, [&](Index v) { return all[0].place == ball.positions[v]; });
  CHECK(is_at_hole);
  CHECK(test::signed_volume(steps.take_mesh()) ==
        doctest::Approx(test::signed_volume(test::icosphere(2))));
}

TEST_CASE("a sheet that cleaning drops is a loss with its share of the area and its place") {
  Mesh mesh = test::joined(test::cube(), test::moved(test::grid(2), {5, 5, 5}));
  RepairSteps steps = steps_on(mesh);
  steps.fill(false, std::numeric_limits<double>::infinity());
  steps.clean();
  const std::vector<RepairStep> all = steps.take_steps();
  REQUIRE(all.size() == 2);
  // Filling closed the sheet, which then has two sides of area 1. The cube has the area 6.
  CHECK(all[1].lost_share == doctest::Approx(2.0 / (6 + 2)));
  CHECK((all[1].lost_place - Vec3(5.5, 5.5, 5)).norm() < 1);
}

TEST_CASE("small components are dropped, and counted") {
  const Mesh small = test::moved(test::scaled(test::icosphere(0), 1e-3), {3, 0, 0});
  RepairSteps steps = steps_on(test::joined(test::cube(), small));
  steps.drop_components(1e-3);
  CHECK(connected_components(steps.mesh()).components.size() == 1);
  const std::vector<RepairStep> all = steps.take_steps();
  REQUIRE(all.size() == 1);
  CHECK(all[0].findings == std::vector<std::string>{"1 component dropped as small components"});
  CHECK(all[0].area_change == doctest::Approx(-surface_area(small)));
}

TEST_CASE("positions are as they will be written") {
  Mesh soup = test::soup_of(test::scaled(test::icosphere(1), 1.0 / 3));
  RepairSteps steps(soup, Scalar::float32, silent);
  steps.stitch({});
  for (const Vec3& point : steps.mesh().positions)
    for (const double x : point) CHECK(x == static_cast<double>(static_cast<float>(x)));
}

TEST_CASE("a surface with one side is refused if it is to be oriented, and stays") {
  const Mesh strip = test::moebius_strip(12);
  RepairSteps steps = steps_on(strip);
  CHECK_THROWS_AS(steps.stitch({.orient = true}), InputError);
  CHECK(steps.mesh().faces == strip.faces);
}

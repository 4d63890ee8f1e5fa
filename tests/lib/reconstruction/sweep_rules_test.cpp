#include "reconstruction/sweep_rules.h"

#include <doctest/doctest.h>

#include "helpers/moving_sweep.h"

using namespace transformesh;

using test::moving;

TEST_CASE("views are wide if nearest ones are more than 40 degrees apart on average") {
  const std::vector<ViewPair> eight{{0, 1, 45}, {0, 2, 50}, {1, 0, 45}, {2, 0, 50}, {2, 1, 39}};
  const std::vector<ViewPair> dense{{0, 1, 45}, {0, 2, 20}, {1, 0, 45}, {2, 0, 20}, {2, 3, 50}};
  CHECK(is_wide(eight));
  CHECK_FALSE(is_wide(dense));
  CHECK_FALSE(is_wide(std::vector<ViewPair>{}));
}

TEST_CASE("an initial mesh is torn if a twentieth of its coverage is lost") {
  CHECK(is_torn(1000, 949));
  CHECK_FALSE(is_torn(1000, 950));
}

TEST_CASE("a surface explodes if it breaks up, leaves the silhouettes or loses coverage") {
  const auto explodes = [](const auto& change) {
    Sweep sweep = moving(0.5);
    change(sweep);
    return is_exploded(sweep, 2);
  };
  CHECK_FALSE(explodes([](Sweep&) {}));
  CHECK(explodes([](Sweep& sweep) { sweep.mesh.topology.components = 101; }));
  CHECK_FALSE(explodes([](Sweep& sweep) { sweep.mesh.topology.components = 100; }));
  CHECK(explodes([](Sweep& sweep) { sweep.steps.last.outside = 301; }));
  CHECK_FALSE(explodes([](Sweep& sweep) { sweep.steps.last.outside = 300; }));
  // An initial mesh that was outside may move in, and a surface that was hardly compared at first
  // is not worse at the end.
  CHECK_FALSE(
      explodes([](Sweep& sweep) { sweep.steps.first.outside = sweep.steps.last.outside = 600; }));
  CHECK(explodes([](Sweep& sweep) { sweep.steps.last.coverage = 0.29; }));
  CHECK_FALSE(
      explodes([](Sweep& sweep) { sweep.steps.first.coverage = sweep.steps.last.coverage = 0.2; }));
  // The limit of components is ten times their number in the initial mesh, if this is above 100.
  Sweep many = moving(0.5);
  many.mesh.topology.components = 500;
  CHECK_FALSE(is_exploded(many, 50));
}

TEST_CASE("windows are those of coarse scales down to scale 2") {
  const WindowRadii radii{5, 2};
  CHECK(radii.at(11.3137) == 5);
  CHECK(radii.at(2) == 5);
  CHECK(radii.at(1.4142) == 2);
  CHECK(radii.at(1) == 2);
}

TEST_CASE("windows that disagree as much as the mean have less weight") {
  CHECK(robust_loss(1, 0.2) == 0.2);
  CHECK(robust_loss(0.5, 0.4) == 0.2);
  CHECK(robust_loss(0, 0.1) == 0);
  CHECK(robust_loss(1e-9, 0.1) == 0.001);
  CHECK(robust_loss(1e9, 0.1) == 1000);
}

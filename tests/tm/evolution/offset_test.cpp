/// Offsets of balls and boxes against Steiner's formula.
#include "tm/evolution/offset.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "helpers/shapes.h"
#include "tm/clean/intersect/intersect.h"
#include "tm/mesh/components.h"
#include "tm/mesh/manifold.h"
#include "tm/mesh/measure.h"
#include "tm/support/error.h"
#include "tm/support/parallel.h"

namespace transformesh {
namespace {

constexpr double pi = std::numbers::pi;

struct Moved {
  Mesh mesh;
  OffsetResult result;
};

Moved moved_by(const Mesh& mesh, double distance, double edge = 0) {
  Document document;
  document.mesh = mesh;
  const OffsetResult result = offset(document, {.distance = distance, .edge = edge});
  CHECK(result.is_done);
  const ManifoldReport found = check_manifold(document.mesh);
  CHECK((found.is_manifold() && found.is_oriented() && found.is_closed()));
  CHECK(find_intersections(document.mesh).empty());
  CHECK(connected_components(document.mesh).components.size() == result.topology.components);
  return {document.mesh, result};
}

double ball(double radius) { return 4.0 / 3 * pi * radius * radius * radius; }

}  // namespace

TEST_CASE("a ball grows and shrinks to a ball") {
  for (const double distance : {0.3, -0.3, -0.7}) {
    CAPTURE(distance);
    const auto [mesh, result] = moved_by(test::icosphere(4), distance);
    CHECK(volume(mesh) == doctest::Approx(ball(1 + distance)).epsilon(0.02));
    CHECK(result.deviation.most < 0.01);
    CHECK(result.deviation.missed < 0.01);
    CHECK(result.deviation.rms <= result.deviation.most);
  }
}

TEST_CASE("a box grows by Steiner's formula and shrinks to a smaller box") {
  const double d = 0.2;
  const double grown = 1 + 6 * d + 12 * pi / 4 * d * d + ball(d);
  CHECK(volume(moved_by(test::cube(), d, 0.04).mesh) == doctest::Approx(grown).epsilon(0.005));
  const auto [small, result] = moved_by(test::cube(), -d, 0.03);
  CHECK(volume(small) == doctest::Approx(0.6 * 0.6 * 0.6).epsilon(0.02));
  CHECK(result.deviation.missed < 0.06);  // corners are cut by the length of two edges at most
}

TEST_CASE("balls that are near become one, and those that are far stay two") {
  const Mesh ball = test::icosphere(3);
  const Mesh pair = test::joined(ball, test::moved(ball, {2.4, 0, 0}));
  CHECK(moved_by(pair, 0.1).result.topology.components == 2);
  CHECK(moved_by(pair, 0.4).result.topology.components == 1);
}

TEST_CASE("a cavity shrinks where the outside grows, and vanishes") {
  const Mesh hollow =
      test::joined(test::icosphere(4), test::reversed(test::scaled(test::icosphere(3), 0.5)));
  const auto [mesh, result] = moved_by(hollow, 0.2);
  CHECK(volume(mesh) == doctest::Approx(ball(1.2) - ball(0.3)).epsilon(0.02));
  CHECK(result.topology.components == 2);
}

TEST_CASE("the bar of a dumbbell vanishes, and its balls are left") {
  // A capsule of three boxes: two thick ones and a thin bar between them.
  const Mesh ends = test::joined(test::cuboid({-2, -0.5, -0.5}, {-1, 0.5, 0.5}),
                                 test::cuboid({1, -0.5, -0.5}, {2, 0.5, 0.5}));
  Mesh dumbbell = test::joined(ends, test::cuboid({-1.2, -0.1, -0.1}, {1.2, 0.1, 0.1}));
  Document document;
  document.mesh = dumbbell;
  clean_in_place(document);
  const auto [mesh, result] = moved_by(document.mesh, -0.2, 0.05);
  CHECK(result.topology.components == 2);
  CHECK(volume(mesh) == doctest::Approx(2 * 0.6 * 0.6 * 0.6).epsilon(0.06));
}

TEST_CASE("what vanishes, what is open and a distance of nothing are refused") {
  Document document;
  document.mesh = test::cube();
  CHECK_THROWS_AS(offset(document, {.distance = -0.6}), GoalError);
  CHECK_THROWS_AS(offset(document, {.distance = 0}), UsageError);
  CHECK_THROWS_AS(offset(document, {.distance = NAN}), UsageError);
  document.mesh = test::cube();
  document.mesh.faces.pop_back();
  CHECK_THROWS_AS(offset(document, {.distance = 0.1}), InputError);
}

TEST_CASE("an offset does not depend on threads") {
  const auto run = [&](int threads) {
    const ThreadLimit limit(threads);
    return moved_by(test::icosphere(3), 0.2).mesh;
  };
  const Mesh first = run(1), second = run(4);
  CHECK(first.positions == second.positions);
  CHECK(first.faces == second.faces);
}

}  // namespace transformesh

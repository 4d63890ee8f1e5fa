// Tests of the oracle itself: it accepts correct results and finds each kind of deliberate fault.
#include "helpers/winding_oracle.h"

#include <doctest/doctest.h>

#include <cmath>

#include "helpers/shapes.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

/// Boxes that do not touch each other: `inner` lies inside of `outer`, `beside` outside of both.
const Mesh outer = cuboid({-2, -2, -2}, {2, 2, 2});
const Mesh inner = cuboid({-1, -1, -1}, {1, 1, 1});
const Mesh beside = cuboid({3, 3, 3}, {4, 4, 4});

bool is_right(const Mesh& input, const Mesh& output, int winding_level = 1) {
  WindingOracleOptions options;
  options.winding_level = winding_level;
  return compare_windings(input, output, options).is_right();
}

std::size_t wrong(const Mesh& input, const Mesh& output) {
  return compare_windings(input, output).wrong;
}

}  // namespace

TEST_CASE("the oracle accepts the boundary of what is enclosed") {
  const Mesh nested = joined(outer, inner);
  CHECK(is_right(nested, outer));
  CHECK(is_right(nested, inner, 2));
  CHECK(is_right(nested, Mesh{}, 3));
  const Mesh hollow = joined(outer, reversed(inner));
  CHECK(is_right(hollow, hollow));
  CHECK(is_right(reversed(outer), Mesh{}));
  const Mesh apart = joined(outer, beside);
  CHECK(is_right(apart, apart));
  CHECK(is_right(joined(apart, apart), apart));
}

TEST_CASE("the oracle tests most of its samples") {
  const WindingOracleResult result = compare_windings(joined(outer, inner), outer);
  CHECK(result.tested + result.undecided >= 2000);
  CHECK(result.undecided < 20);
  CHECK(describe(result) == "tested " + std::to_string(result.tested) + " wrong 0 undecided " +
                                std::to_string(result.undecided));
}

TEST_CASE("the oracle finds components flipped, dropped and kept") {
  const Mesh apart = joined(outer, beside);
  CHECK(wrong(apart, joined(outer, reversed(beside))) > 0);
  CHECK(wrong(apart, outer) > 0);
  CHECK(wrong(apart, joined(apart, beside)) > 0);
  CHECK(wrong(joined(outer, inner), joined(outer, inner)) > 0);
  CHECK(wrong(joined(outer, reversed(inner)), outer) > 0);
  CHECK(wrong(apart, Mesh{}) > 0);
  CHECK(wrong(outer, reversed(outer)) > 0);
  CHECK(wrong(reversed(outer), reversed(outer)) > 0);
}

TEST_CASE("the oracle finds a missing face, however small") {
  const Mesh ball = icosphere(4);
  Mesh open = ball;
  open.faces.erase(open.faces.begin() + 777);
  CHECK(wrong(ball, open) > 0);
  CHECK(wrong(open, ball) == 0);
  CHECK_FALSE(is_right(open, ball));
}

TEST_CASE("the oracle finds a small inner part, and dents a quarter of an edge deep") {
  const Mesh ball = icosphere(4);
  const Mesh speck = moved(scaled(icosphere(1), 0.02), {0.5, 0.1, 0.2});
  CHECK(is_right(joined(ball, speck), ball));
  CHECK(wrong(joined(ball, speck), joined(ball, speck)) > 0);

  Mesh dented = ball;
  for (std::size_t v = 0; v < dented.positions.size(); v += 50) dented.positions[v] *= 0.98;
  CHECK(wrong(ball, dented) > 0);
}

TEST_CASE("the oracle forgives rounding within its tolerance only") {
  const Mesh ball = icosphere(4);
  Mesh rounded = ball;
  for (Vec3& point : rounded.positions) point = point.cast<float>().cast<double>();
  WindingOracleOptions options;
  options.tolerance = 1e-6;
  CHECK(compare_windings(ball, rounded, options).is_right());

  Mesh shrunk = scaled(ball, 0.999);
  CHECK(compare_windings(ball, shrunk, options).wrong > 0);
  options.tolerance = 2e-3;
  CHECK(compare_windings(ball, shrunk, options).wrong == 0);
}

TEST_CASE("the oracle reports the first wrong sample and repeats itself") {
  const WindingOracleResult result = compare_windings(joined(outer, inner), joined(outer, inner));
  REQUIRE(result.wrong > 0);
  CHECK(result.wrong_point.cwiseAbs().maxCoeff() < 1);
  CHECK(std::abs(result.wrong_input_winding - 2) < 1e-9);
  CHECK(std::abs(result.wrong_output_winding - 2) < 1e-9);
  CHECK(describe(result) == describe(compare_windings(joined(outer, inner), joined(outer, inner))));

  WindingOracleOptions other;
  other.seed = 2;
  CHECK(describe(result) !=
        describe(compare_windings(joined(outer, inner), joined(outer, inner), other)));
}

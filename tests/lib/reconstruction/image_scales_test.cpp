#include "reconstruction/image_scales.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"
#include "transformesh/measure.h"

using namespace transformesh;
using doctest::Approx;

namespace {

ScaleOptions from(double coarsest, double edge = 3) { return {coarsest, edge, edge}; }

}  // namespace

TEST_CASE("scales go from the coarsest to 1 by the square root of 2, and edges with them") {
  const std::vector<ScaleStep> scale_steps = coarse_to_fine(from(2), 640, 0.5);
  REQUIRE(scale_steps.size() == 3);
  CHECK(scale_steps[0].scale == 2);
  CHECK(scale_steps[1].scale == 1.4142);
  CHECK(scale_steps[2].scale == 1);
  CHECK(scale_steps[0].edge == 3);
  CHECK(scale_steps[1].edge == 2.12132034);
  CHECK(scale_steps[2].edge == 1.5);
}

TEST_CASE("a coarsest scale between two is rounded up, except if it is hardly larger") {
  CHECK(coarse_to_fine(from(2.1), 640, 1).front().scale == 2.8284);
  CHECK(coarse_to_fine(from(2.001), 640, 1).front().scale == 2);
  CHECK(coarse_to_fine(from(1), 640, 1).size() == 1);
}

TEST_CASE("the default coarsest scale makes photographs 28 pixels wide, and is at most 11.3") {
  CHECK(coarse_to_fine({}, 160, 1).front().scale == 5.6569);
  CHECK(coarse_to_fine({}, 6000, 1).front().scale == 11.3137);
  CHECK(coarse_to_fine({}, 20, 1).front().scale == 1);
}

TEST_CASE("at full scale edges become as short as wanted") {
  const std::vector<ScaleStep> scale_steps = coarse_to_fine({1, 4, 2}, 640, 1);
  REQUIRE(scale_steps.size() == 3);
  CHECK(scale_steps[1].edge == 2.82842712);
  CHECK(scale_steps[2].edge == 2);
  CHECK(scale_steps[2].scale == 1);
}

TEST_CASE("edges become about as long as wanted, and those that are so stay") {
  Document document;
  document.mesh = test::icosphere(4);
  const Mesh before = document.mesh;
  coarsen(document, 0.1);
  CHECK(document.mesh.positions == before.positions);
  coarsen(document, 0.6);
  const double mean = edge_lengths(document.mesh).mean;
  CHECK(mean > 0.25);
  CHECK(mean < 0.7);
}

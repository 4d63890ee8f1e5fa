#include "flow/normal_flow.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "helpers/shapes.h"
#include "transformesh/flow.h"
#include "transformesh/measure.h"
#include "transformesh/shapes.h"

using namespace transformesh;
using doctest::Approx;

namespace {

void advance(Mesh& mesh, const Motion& motion, double duration, int steps) {
  const double span = duration / steps;
  for (int i = 0; i < steps; ++i) {
    const auto velocities = motion.velocity(mesh, {i * span, 0, 0}, Progress());
    for (std::size_t v = 0; v < velocities.size(); ++v) mesh.positions[v] += span * velocities[v];
  }
}

/// Returns the unit cube with approximately `faces` faces.
Mesh cube_of(std::size_t faces) {
  ShapeOptions options;
  options.kind = "box";
  options.parameters = {"1", "1", "1"};
  options.faces = faces;
  return make_shape(options);
}

}  // namespace

TEST_CASE("an eroding cube stays a cube whose planes move by the speed") {
  Mesh cube = cube_of(3000);
  const Box before = bounding_box(cube);
  advance(cube, make_flow("normal", {.speed = -1}).motion, 0.01, 1);
  const Box after = bounding_box(cube);
  CHECK((after.min() - before.min() - Vec3::Constant(0.01)).norm() < 1e-12);
  CHECK(volume(cube) == Approx(0.98 * 0.98 * 0.98).epsilon(1e-9));
  Mesh coarse = test::cube();
  advance(coarse, make_flow("normal", {.speed = -1}).motion, 0.4, 4);
  CHECK(volume(coarse) == Approx(0.2 * 0.2 * 0.2).epsilon(1e-9));
}

TEST_CASE("a growing cube becomes the body at a distance, with round edges") {
  const double t = 0.05;
  const double exact =
      1 + 6 * t + 3 * std::numbers::pi * t * t + 4.0 / 3 * std::numbers::pi * t * t * t;
  const auto error = [&](std::size_t faces) {
    Mesh cube = cube_of(faces);
    advance(cube, make_flow("normal").motion, t, 10);
    const Box box = bounding_box(cube);
    CHECK(box.sizes().maxCoeff() == Approx(1 + 2 * t).epsilon(0.01));
    return std::abs(volume(cube) - exact);
  };
  const double coarse = error(2000), fine = error(20000);
  MESSAGE("volume errors ", coarse, " ", fine, " of ", exact);
  CHECK(fine < 0.6 * coarse);
  CHECK(fine < 0.01 * exact);
}

TEST_CASE("spheres grow and shrink by the speed") {
  for (const double speed : {0.5, -0.5}) {
    Mesh sphere = make_sphere(Vec3::Zero(), 1, 5000);
    advance(sphere, make_flow("normal", {.speed = speed}).motion, 0.5, 20);
    for (const Vec3& p : sphere.positions)
      CHECK(p.norm() == Approx(1 + 0.5 * speed).epsilon(0.005));
  }
}

TEST_CASE("a concave edge recedes as a round one and grows as a sharp one") {
  // Two planes that meet at the y axis in a valley of 90 degrees.
  Mesh valley;
  valley.positions = {{-1, 0, 1}, {-1, 1, 1}, {0, 0, 0}, {0, 1, 0}, {1, 0, 1}, {1, 1, 1}};
  valley.faces = {{0, 2, 3}, {0, 3, 1}, {2, 4, 5}, {2, 5, 3}};
  const std::vector<double> grow(6, 1), recede(6, -1);
  CHECK(huygens_velocities(valley, grow)[2].z() == Approx(std::sqrt(2)));
  CHECK(huygens_velocities(valley, recede)[2].z() == Approx(-1));
}

TEST_CASE("a column and a grid multiply the speed") {
  Mesh sphere = make_sphere(Vec3::Zero(), 1, 500);
  Column& column = sphere.vertex_columns.get("rate", Scalar::float64, sphere.positions.size());
  for (std::size_t v = 0; v < sphere.positions.size(); ++v)
    column.values[v] = sphere.positions[v].z() > 0 ? 3 : 0;
  FlowGrid grid;
  grid.components = 1;
  grid.origin = Vec3(-2, 0, 0);
  grid.spacing = Vec3(4, 1, 1);
  grid.size = {2, 1, 1};
  grid.values = {0, 4};  // the linear function 2 + x
  const Flow flow = make_flow("normal", {.speed = 0.5, .column = "rate", .grids = {grid}});
  const auto velocities = flow.motion.velocity(sphere, {}, Progress());
  for (std::size_t v = 0; v < velocities.size(); ++v) {
    const Vec3& p = sphere.positions[v];
    const double expected = p.z() > 0 ? 0.5 * 3 * (2 + p.x()) : 0;
    CHECK(velocities[v].dot(p) == Approx(expected).epsilon(0.01));
  }
  const Motion missing = make_flow("normal", {.column = "no such column"}).motion;
  CHECK_THROWS_AS(missing.velocity(sphere, {}, Progress()), InputError);
}

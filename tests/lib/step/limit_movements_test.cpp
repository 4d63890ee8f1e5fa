#include "step/limit_movements.h"

#include <doctest/doctest.h>

#include <cmath>
#include <utility>

#include "geometry/keep_out.h"
#include "helpers/mesh_distance.h"
#include "helpers/shapes.h"
#include "transformesh/displace.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"
#include "transformesh/velocity.h"

using namespace transformesh;
using doctest::Approx;
using test::distance_of_meshes;

namespace {

DisplaceOptions far_steps(const Mesh& surface, double gap) {
  DisplaceOptions options;
  options.alpha = 5;
  options.keep_out = {&surface, gap};
  return options;
}

}  // namespace

TEST_CASE("a ball that grows stops at the gap from the shell around it") {
  const Mesh shell = test::scaled(test::icosphere(2), 1.3);
  Mesh ball = test::icosphere(2);
  const double before = volume(ball);
  std::size_t held = 0;
  for (int step = 0; step < 6; ++step) {
    held += displace(ball, normal_velocities(ball, 0.1), far_steps(shell, 0.05)).held_back;
    CHECK(distance_of_meshes(ball, shell) >= 0.05 * (1 - 1e-12));
  }
  CHECK(held > 100);
  // The ball came near the inside of the shell, whose flat faces are .05 nearer than its corners.
  CHECK(volume(ball) > 1.4 * before);
  CHECK(distance_of_meshes(ball, shell) < 0.08);
}

TEST_CASE("movement away and along is free, however near") {
  Mesh plate = test::grid(10);
  const Mesh ceiling = test::moved(test::grid(3), Vec3(0, 0, 0.01));
  const std::vector<Vec3> along(plate.positions.size(), Vec3(0.3, 0, 0));
  auto result = displace(plate, along, far_steps(ceiling, 0.01));
  CHECK(result.held_back == 0);
  CHECK(result.near_keep_out == 0);
  const std::vector<Vec3> away(plate.positions.size(), Vec3(0, 0, -0.3));
  CHECK(displace(plate, away, far_steps(ceiling, 0.01)).held_back == 0);
  // Movement away is free even if the gap is larger than the distance.
  const std::vector<Vec3> back(plate.positions.size(), Vec3(0, 0, 0.295));
  CHECK(displace(plate, back, far_steps(ceiling, 1e-3)).held_back == 0);
  result = displace(plate, away, far_steps(ceiling, 0.1));
  CHECK(result.held_back == 0);
  CHECK(result.near_keep_out > plate.faces.size() / 2);
}

TEST_CASE("no step jumps over a body, and what is far from it goes its whole way") {
  Mesh plate = test::grid(10);
  const Mesh pebble = test::moved(test::scaled(test::icosphere(1), 0.02), Vec3(0.52, 0.47, 0.2));
  const std::vector<Vec3> up(plate.positions.size(), Vec3(0, 0, 0.4));
  const DisplaceResult result = displace(plate, up, far_steps(pebble, 0.01));
  CHECK(result.held_back > 0);
  CHECK(result.held_back < 40);
  CHECK(distance_of_meshes(plate, pebble) >= 0.01 * (1 - 1e-12));
  CHECK(plate.positions[0].z() == 0.4);
  // The vertices over the pebble have not passed its middle.
  for (std::size_t v = 0; v < plate.positions.size(); ++v)
    if ((plate.positions[v].head<2>() - Eigen::Vector2d(0.52, 0.47)).norm() < 0.07)
      CHECK(plate.positions[v].z() < 0.2);
}

TEST_CASE("movements are halved until they are smaller than the gap") {
  const Mesh plate = test::grid(10);
  const Mesh ceiling = test::moved(test::grid(3), Vec3(0, 0, 0.001));
  // Ten halvings of .512 give .0005. If the gap is .0009, .0001 is free, and .0005 is the first
  // movement below the gap.
  for (const auto& [gap, way] : {std::pair(1e-6, 0.0005), std::pair(0.0009, 0.0)}) {
    std::vector<Vec3> movements(plate.positions.size(), Vec3(0, 0, 0.512));
    const LimitedMovements limited =
        limit_movements(plate, {&ceiling, gap}, Scalar::float64, movements);
    CHECK(limited.held_back == movements.size());
    for (const Vec3& movement : movements) CHECK(movement == Vec3(0, 0, way));
  }
}

TEST_CASE("floats keep the gap as they are written") {
  Mesh ball = test::icosphere(2);
  for (Vec3& p : ball.positions) p = p.cast<float>().cast<double>();
  const Mesh shell = test::scaled(test::icosphere(2), 1.1);
  DisplaceOptions options = far_steps(shell, 0.02);
  options.coordinate = Scalar::float32;
  displace(ball, normal_velocities(ball, 0.2), options);
  for (const Vec3& p : ball.positions) CHECK(p == p.cast<float>().cast<double>());
  CHECK(distance_of_meshes(ball, shell) >= 0.02 * (1 - 1e-12));
}

TEST_CASE("without an obstacle a step is unchanged; one that is intersected is refused") {
  const Mesh ball = test::icosphere(2);
  Mesh with = ball;
  Mesh without = ball;
  const Mesh far = test::moved(ball, Vec3(100, 0, 0));
  displace(with, normal_velocities(ball, 0.1), far_steps(far, 1));
  DisplaceOptions options = far_steps(far, 1);
  options.keep_out = {};
  displace(without, normal_velocities(ball, 0.1), options);
  CHECK(with.positions == without.positions);
  const Mesh crossing = test::moved(ball, Vec3(1, 0, 0));
  CHECK_THROWS_AS(displace(with, normal_velocities(with, 0.1), far_steps(crossing, 0.1)),
                  InputError);
  CHECK_THROWS_AS(displace(with, normal_velocities(with, 0.1), far_steps(far, 0)), UsageError);
}

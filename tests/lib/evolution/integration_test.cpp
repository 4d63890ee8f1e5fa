#include "evolution/integration.h"

#include <doctest/doctest.h>

#include <cmath>

#include "helpers/shapes.h"
#include "transformesh/errors.h"

using namespace transformesh;

namespace {

/// A rotation about the z axis whose angular velocity grows with time. After time t the angle is t
/// + t^2 / 2.
Motion turning() {
  return {[](const Mesh& mesh, const Moment& moment, const Progress&) {
    std::vector<Vec3> velocities;
    for (const Vec3& p : mesh.positions)
      velocities.emplace_back((1 + moment.time) * Vec3(-p.y(), p.x(), 0));
    return velocities;
  }};
}

/// Returns the largest distance to the exact positions after unit time in `steps` steps.
double error_of(Integrator integrator, int steps) {
  const Motion motion = turning();
  Mesh mesh = test::tetrahedron();
  const Mesh start = mesh;
  for (int i = 0; i < steps; ++i) {
    const Integration integration(motion, mesh, double(i) / steps, integrator, Progress());
    const Integrated step = integration.over(1.0 / steps);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
      mesh.positions[v] += step.displacements[v];
  }
  const Eigen::AngleAxisd exact(1.5, Vec3::UnitZ());
  double error = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    error = std::max(error, (mesh.positions[v] - exact * start.positions[v]).norm());
  return error;
}

double order_of(Integrator integrator) {
  return std::log2(error_of(integrator, 40) / error_of(integrator, 80));
}

}  // namespace

TEST_CASE("integrators converge with their order") {
  CHECK(order_of(Integrator::euler) == doctest::Approx(1).epsilon(0.1));
  CHECK(order_of(Integrator::midpoint) == doctest::Approx(2).epsilon(0.05));
  CHECK(order_of(Integrator::rk4) == doctest::Approx(4).epsilon(0.05));
}

TEST_CASE("the error estimate vanishes with the order that the choice of the span assumes") {
  const Motion motion = turning();
  const Mesh mesh = test::tetrahedron();
  for (const Integrator integrator : {Integrator::midpoint, Integrator::rk4}) {
    const Integration integration(motion, mesh, 0, integrator, Progress());
    const double ratio = integration.over(0.02).error / integration.over(0.01).error;
    CHECK(std::log2(ratio) == doctest::Approx(error_order(integrator)).epsilon(0.1));
  }
}

TEST_CASE("a motion with an integrator of its own is evaluated once, with the span") {
  int calls = 0;
  Motion motion = turning();
  motion.displacement = [&](const Mesh& mesh, const Moment& moment, const Progress&) {
    ++calls;
    return std::vector<Vec3>(mesh.positions.size(), Vec3(moment.span, 0, 0));
  };
  const Mesh mesh = test::tetrahedron();
  const Integration integration(motion, mesh, 0, Integrator::rk4, Progress());
  CHECK(integration.initial_velocities().empty());
  CHECK(integration.over(0.25).displacements[3] == Vec3(0.25, 0, 0));
  CHECK(calls == 1);
}

TEST_CASE("motions with a wrong number of vectors, or one that is not finite, are refused") {
  const Mesh mesh = test::tetrahedron();
  const auto refused = [&](std::vector<Vec3> vectors) {
    const Motion motion{[&](const Mesh&, const Moment&, const Progress&) { return vectors; }};
    CHECK_THROWS_AS(Integration(motion, mesh, 0, Integrator::euler, Progress()), InputError);
  };
  refused(std::vector<Vec3>(3, Vec3::Zero()));
  std::vector<Vec3> vectors(4, Vec3::Zero());
  vectors[2].y() = NAN;
  refused(vectors);
}

#include "evolution/time_span.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"
#include "mesh/local_measures.h"
#include "transformesh/errors.h"

using namespace transformesh;

namespace {

Motion moving_at(double speed) {
  return {[speed](const Mesh& mesh, const Moment&, const Progress&) {
    return std::vector<Vec3>(mesh.positions.size(), Vec3(speed, 0, 0));
  }};
}

/// A motion whose second stage differs from the first in proportion to the span.
Motion accelerating() {
  return {[](const Mesh& mesh, const Moment& moment, const Progress&) {
    return std::vector<Vec3>(mesh.positions.size(), Vec3(moment.time, 0, 0));
  }};
}

TrialStep step_of(const Motion& motion, const TimeOptions& options, double remaining,
                  double longest = 1e300) {
  const Mesh mesh = test::icosphere(2);
  const Integration integration(motion, mesh, 0, options.integrator, Progress());
  return chosen_step(integration, options, remaining, longest, halfedge_lengths(mesh).vertex_mean);
}

}  // namespace

TEST_CASE("no vertex moves farther than the limit, and the spans divide the time equally") {
  const TrialStep step = step_of(moving_at(1), {.max_move = 0.5}, 10);
  CHECK(step.max_move <= 0.5);
  CHECK(step.max_move > 0.4);
  const double count = 10 / step.span;
  CHECK(count == doctest::Approx(std::round(count)).epsilon(1e-12));
  CHECK(step.integrated.displacements[7].x() == doctest::Approx(step.span));
}

TEST_CASE("the last step ends at the end") {
  CHECK(step_of(moving_at(1), {}, 1e-3).span == 1e-3);
  CHECK(step_of(moving_at(0), {}, 4).span == 4);
  CHECK(step_of(moving_at(1), {.span = 0.3}, 4).span == 0.3);
  CHECK(step_of(moving_at(1), {.span = 0.3}, 0.1).span == 0.1);
  // After nine spans of .1 until time 1, rounding may make the remaining time exceed the span.
  CHECK(step_of(moving_at(1), {.span = 0.1}, 0.1 + 1e-16).span == 0.1 + 1e-16);
}

TEST_CASE("the tolerance of the error shortens the span, and only as far as necessary") {
  // The step differs from a step of Euler's method by span^2 / 2.
  const TrialStep step = step_of(accelerating(), {.max_move = 1e9, .tolerance = 1e-4}, 10);
  CHECK(step.integrated.error <= 1e-4);
  CHECK(step.integrated.error > 0.5e-4);
}

TEST_CASE("a limit of the span holds for given spans as well") {
  CHECK(step_of(moving_at(1e-9), {}, 1, 0.25).span == 0.25);
  CHECK(step_of(moving_at(1e-9), {.span = 0.5}, 1, 0.25).span == 0.25);
}

TEST_CASE("the next span is a little below the limits, and at most half as long again") {
  const TimeOptions options{.integrator = Integrator::rk4, .max_move = 0.5, .tolerance = 1e-3};
  const auto next = [&](double max_move, double error) {
    return next_span({2, {{}, error}, max_move}, options);
  };
  CHECK(next(0, 0) == 3);
  CHECK(next(0.1, 1e-6) == 3);
  CHECK(next(0.5, 0) == doctest::Approx(1.8));
  CHECK(next(0.6, 0) == doctest::Approx(1.5));
  CHECK(next(0.1, 1e-3) == doctest::Approx(1.8));
  CHECK(next(0.1, 8e-3) == doctest::Approx(0.9));  // the error grows with the third power
}

TEST_CASE("a motion that needs endless steps is refused") {
  CHECK_THROWS_AS(step_of(moving_at(1e14), {}, 1), GoalError);
}

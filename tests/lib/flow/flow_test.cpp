#include "transformesh/flow.h"

#include <doctest/doctest.h>

#include "flow/analytic_fields.h"
#include "flow/flow_columns.h"
#include "helpers/shapes.h"
#include "transformesh/control.h"

using namespace transformesh;

namespace {

FlowGrid uniform_grid(const Vec3& velocity, std::optional<double> time) {
  FlowGrid grid;
  grid.size = {2, 2, 2};
  for (int i = 0; i < 8; ++i)
    grid.values.insert(grid.values.end(), {velocity.x(), velocity.y(), velocity.z()});
  grid.time = time;
  return grid;
}

}  // namespace

TEST_CASE("each flow has a velocity at every vertex, the same for any number of threads") {
  const Mesh mesh = test::icosphere(4);
  for (const FlowKind& kind : flow_kinds()) {
    CAPTURE(kind.name);
    FlowOptions options;
    options.speed = 0.5;
    if (kind.name == "grid") options.grids = {uniform_grid(Vec3(1, 2, 3), {})};
    const Flow flow = make_flow(kind.name, options);
    const Moment moment{0.3, 1e-3, 0};
    const auto evaluate = [&](int threads) {
      const ThreadLimit limit(threads);
      auto vectors = flow.motion.velocity(mesh, moment, Progress());
      if (!flow.motion.displacement) return vectors;
      const auto displacements = flow.motion.displacement(mesh, moment, Progress());
      vectors.insert(vectors.end(), displacements.begin(), displacements.end());
      return vectors;
    };
    const auto vectors = evaluate(1);
    REQUIRE(vectors.size() % mesh.positions.size() == 0);
    for (const Vec3& vector : vectors) REQUIRE(vector.allFinite());
    CHECK(evaluate(2) == vectors);
    CHECK(evaluate(4) == vectors);
    const AnalyticField field = analytic_field(kind.name, options);
    if (field) CHECK(vectors[7].isApprox(0.5 * field(0.3)(mesh.positions[7])));
  }
}

TEST_CASE("options that a flow does not have, or that make no sense, are refused") {
  CHECK_THROWS_AS(make_flow("vortx"), UsageError);
  CHECK_THROWS_AS(make_flow("abc", {.period = 1}), UsageError);
  CHECK_THROWS_AS(make_flow("vortex", {.center = Vec3(0, 0, 0)}), UsageError);
  CHECK_THROWS_AS(make_flow("shear", {.direction = Vec3(0, 0, 1)}), UsageError);
  CHECK_THROWS_AS(make_flow("rotation", {.column = "speed"}), UsageError);
  CHECK_THROWS_AS(make_flow("rotation", {.grids = {uniform_grid(Vec3::Ones(), {})}}), UsageError);
  CHECK_THROWS_AS(make_flow("rotation", {.period = 0}), UsageError);
  CHECK_THROWS_AS(make_flow("rotation", {.direction = Vec3::Zero()}), UsageError);
  CHECK_THROWS_AS(make_flow("rotation", {.center = Vec3(0, 0, 1.0 / 0.0)}), UsageError);
  CHECK_THROWS_AS(make_flow("rotation", {.speed = 0.0 / 0.0}), UsageError);
  CHECK_THROWS_AS(make_flow("mean-curvature", {.speed = -1}), UsageError);
  CHECK_THROWS_AS(make_flow("surface-diffusion", {.speed = 0}), UsageError);
  CHECK_THROWS_AS(make_flow("grid"), UsageError);
}

TEST_CASE("vertices and times outside of the grids are counted") {
  Mesh mesh;
  mesh.positions = {{0.5, 0.5, 0.5}, {2, 0, 0}, {0, -1, 0}};
  const Flow flow = make_flow(
      "grid",
      {.speed = 2, .grids = {uniform_grid(Vec3(0, 0, 3), 1), uniform_grid(Vec3::Zero(), 0)}});
  CHECK(flow.motion.velocity(mesh, {0.5, 0, 0}, Progress())[1].isApprox(Vec3(0, 0, 3)));
  CHECK(flow.counts->outside == 2);
  CHECK(!flow.counts->is_time_outside);
  mesh.positions[2].y() = 1;
  CHECK(flow.motion.velocity(mesh, {4, 0, 0}, Progress())[0].isApprox(Vec3(0, 0, 6)));
  CHECK(flow.counts->outside == 2);  // the largest of all evaluations
  CHECK(flow.counts->is_time_outside);
}

TEST_CASE("columns hold velocities, or those of a step over a span") {
  Mesh mesh = test::icosphere(3);
  mesh.vertex_columns.get("vx", Scalar::int8, mesh.positions.size());
  const Motion motion = make_flow("mean-curvature").motion;
  const FlowSpeeds speeds = add_flow_columns(mesh, motion, {0, 0.1, 0});
  const auto step = motion.displacement(mesh, {0, 0.1, 0}, Progress());
  double largest = 0;
  for (std::size_t v = 0; v < step.size(); ++v) {
    CHECK(mesh.vertex_columns.find("vz")->values[v] == step[v].z() / 0.1);
    largest = std::max(largest, step[v].norm() / 0.1);
  }
  CHECK(mesh.vertex_columns.find("vx")->type == Scalar::float64);
  CHECK(speeds.maximum == doctest::Approx(largest));
  CHECK(speeds.rms <= speeds.maximum);
  // An implicit step takes a radius r to r / (1 + 2 span / r^2). Two half steps are extrapolated.
  const auto implicit = [](double r, double span) { return r / (1 + 2 * span / (r * r)); };
  const double radius = 2 * implicit(implicit(1, 0.05), 0.05) - implicit(1, 0.1);
  CHECK(speeds.rms == doctest::Approx((1 - radius) / 0.1).epsilon(0.01));
  const Motion broken{[](const Mesh& m, const Moment&, const Progress&) {
    return std::vector<Vec3>(m.positions.size(), Vec3(0, 0, 1.0 / 0.0));
  }};
  CHECK_THROWS_AS(add_flow_columns(mesh, broken, {}), InputError);
}

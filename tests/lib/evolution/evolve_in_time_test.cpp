#include "transformesh/evolve_in_time.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "evolution/recorded_loops.h"
#include "helpers/revolution_flow.h"
#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"
#include "transformesh/errors.h"
#include "transformesh/flow.h"
#include "transformesh/measure.h"
#include "transformesh/mesh_io.h"
#include "transformesh/shapes.h"
#include "transformesh/velocity.h"

using namespace transformesh;

namespace {

EvolveOptions unsmoothed() {
  EvolveOptions options;
  options.iteration.remesh.smoothing = Smoothing::none;
  return options;
}

Motion growing(double speed) {
  return {[speed](const Mesh& mesh, const Moment&, const Progress&) {
    return normal_velocities(mesh, speed);
  }};
}

/// Two balls of radius 1 whose surfaces are at the distance `apart`. The right one moves to the
/// left at unit speed.
Document two_balls(double apart) {
  Document document;
  document.mesh =
      test::joined(test::icosphere(3), test::moved(test::icosphere(3), Vec3(2 + apart, 0, 0)));
  Column& mask =
      document.mesh.vertex_columns.get("mask", Scalar::float64, document.mesh.positions.size());
  for (std::size_t v = mask.values.size() / 2; v < mask.values.size(); ++v) mask.values[v] = 1;
  return document;
}

Motion approaching() {
  return {[](const Mesh& mesh, const Moment&, const Progress&) {
    std::vector<Vec3> velocities;
    for (const double share : mesh.vertex_columns.find("mask")->values)
      velocities.emplace_back(-share, 0, 0);
    return velocities;
  }};
}

/// Returns the relative error of the volume after mean-curvature flow with default steps.
double curvature_error(ShapeOptions shape, std::size_t faces, double end,
                       const test::Profile& start) {
  shape.faces = faces;
  Mesh mesh = make_shape(shape);
  evolve_in_time(mesh, make_flow("mean-curvature").motion, {.end = end}, unsmoothed());
  test::RevolutionFlow exact(start);
  exact.advance_to(end);
  return volume(mesh) / exact.volume() - 1;
}

}  // namespace

TEST_CASE("default steps take bodies of 5,000 faces within 1 % of the one-dimensional solver") {
  const auto check = [](const ShapeOptions& shape, double end, const test::Profile& start) {
    const double coarse = curvature_error(shape, 1250, end, start);
    const double fine = curvature_error(shape, 5000, end, start);
    MESSAGE(shape.kind, ": errors of the volume ", coarse, " ", fine);
    CHECK(std::abs(fine) < 0.01);
    CHECK(std::abs(fine) < 0.4 * std::abs(coarse));
  };
  ShapeOptions sphere, torus, dumbbell, ellipsoid;
  sphere.kind = "sphere";
  sphere.radius = 1;
  check(sphere, 0.1875, test::ellipsoid_profile(1, 1, 201));
  torus.kind = "torus";
  torus.radius = 1;
  torus.tube = 0.4;
  check(torus, 0.06, test::torus_profile(1, 0.4, 200));
  dumbbell.kind = "dumbbell";
  dumbbell.neck = 0.25;
  check(dumbbell, 0.04, test::dumbbell_profile(0.25, 201));
  ellipsoid.kind = "ellipsoid";
  ellipsoid.parameters = {"0.5", "0.5", "1"};
  check(ellipsoid, 0.06, test::ellipsoid_profile(0.5, 1, 201));
}

TEST_CASE("a sphere that grows with unit speed has radius 1 + t at time t") {
  Mesh mesh = test::icosphere(4);
  const TimeResult result = evolve_in_time(mesh, growing(1), {.end = 0.5}, unsmoothed());
  CHECK(result.evolution.is_done);
  CHECK(result.time == 0.5);
  const double exact = 4 * std::numbers::pi / 3 * std::pow(1.5, 3);
  CHECK(volume(mesh) == doctest::Approx(exact).epsilon(0.01));
  CHECK(result.volume == volume(mesh));
}

TEST_CASE("steps continue in time, and their stages lie within the step") {
  Mesh mesh = test::icosphere(2);
  double last = -1;
  const Motion motion{[&](const Mesh& now, const Moment& moment, const Progress&) {
    CHECK(moment.time >= last);
    last = moment.time;
    return std::vector<Vec3>(now.positions.size(), Vec3(2 * moment.time, 0, 0));
  }};
  evolve_in_time(mesh, motion, {.end = 1, .span = 0.1, .integrator = Integrator::rk4},
                 unsmoothed());
  CHECK(last == doctest::Approx(1));
  // The mesh moved at the speed 2 t, hence by 1 from t = 0 to t = 1.
  CHECK(bounding_box(mesh).center().x() == doctest::Approx(1).epsilon(1e-3));
}

TEST_CASE("a motion with an integrator of its own is seldom evaluated in vain") {
  Mesh mesh = test::icosphere(3);
  std::size_t calls = 0;
  Motion motion = growing(1);
  motion.displacement = [&](const Mesh& now, const Moment& moment, const Progress&) {
    ++calls;
    return normal_velocities(now, moment.span);
  };
  const TimeResult result = evolve_in_time(mesh, motion, {.end = 1}, unsmoothed());
  CHECK(result.evolution.iterations > 10);
  // The span of the first step is found by two trials, whose evaluations are not used.
  CHECK(calls <= result.evolution.iterations + 3);
  CHECK(result.max_move <= 0.5);
}

TEST_CASE("the time at which two balls touch is found within the tolerance") {
  Document document = two_balls(0.3);
  Record record;
  double merged_at = 0;
  LoopOptions loop;
  TimeOptions time{.end = 0.4, .event_tolerance = 1e-3};
  EvolveOptions options = unsmoothed();
  options.until.components = 1;
  const TimeResult result =
      evolve_in_time(document, approaching(), time, options, loop, record, Progress());
  merged_at = result.time;
  CHECK(result.evolution.last.topology == Topology{1, 0});
  CHECK(result.repeated > 0);
  CHECK(merged_at == doctest::Approx(0.3).epsilon(0.004));
}

TEST_CASE("a ball that shrinks to nothing vanishes at the time of its radius") {
  Document document;
  document.mesh = test::icosphere(3);
  EvolveOptions options = unsmoothed();
  options.finds_events = true;
  const TimeResult result = evolve_in_time(document, growing(-1), {.end = 3}, options);
  CHECK(document.mesh.faces.empty());
  CHECK(result.evolution.is_done);
  CHECK(result.time > 0.8);
  CHECK(result.time <= 1);
  REQUIRE(result.evolution.events.size() == 1);
  CHECK(result.evolution.events[0].kind == EventKind::component_vanished);
}

TEST_CASE("long edges of the source are split before the first step") {
  const double speed = 0.2;
  for (const bool curved : {false, true}) {
    Mesh mesh = test::cube();
    EvolveOptions options = unsmoothed();
    options.iteration.remesh.curved = curved;
    options.iteration.max_edge = {0.1};
    options.iteration.min_edge = {0.05};
    evolve_in_time(mesh, make_flow("normal").motion, {.end = speed}, options);
    // The points within a distance r of the unit cube have this volume, by Steiner's formula.
    const double exact = 1 + 6 * speed + 3 * std::numbers::pi * speed * speed +
                         4 * std::numbers::pi / 3 * std::pow(speed, 3);
    CHECK(volume(mesh) == doctest::Approx(exact).epsilon(0.03));
  }
}

TEST_CASE("volume that remeshing removes is reported") {
  Document document;
  document.mesh = test::cuboid(Vec3::Zero(), {2, 1, 0.3});
  const Motion carried{[](const Mesh& mesh, const Moment&, const Progress&) {
    return std::vector<Vec3>(mesh.positions.size(), Vec3::UnitX());
  }};
  const TimeResult result = evolve_in_time(document, carried, {.end = 1}, unsmoothed());
  CHECK(volume(document.mesh) - result.volume_drift == doctest::Approx(0.6));
}

TEST_CASE("volume is kept to rounding while a sphere is carried and remeshed") {
  Mesh mesh = test::icosphere(3);
  const double before = volume(mesh);
  const Motion turning{[](const Mesh& now, const Moment&, const Progress&) {
    std::vector<Vec3> velocities;
    for (const Vec3& p : now.positions) velocities.emplace_back(Vec3(-p.y(), p.x(), 0));
    return velocities;
  }};
  EvolveOptions options = unsmoothed();
  options.iteration.max_edge = {1.05, Length::Unit::reference_edge};
  const TimeOptions time{.end = 3, .integrator = Integrator::rk4, .keep_volume = true};
  const TimeResult result = evolve_in_time(mesh, turning, time, options);
  CHECK(std::abs(result.volume_drift) < 1e-10 * before);
  // The volume does not drift, but the integrator's error changes it slightly.
  CHECK(volume(mesh) == doctest::Approx(before).epsilon(1e-6));
}

TEST_CASE("a run that continues ends with the same bytes") {
  const auto bytes = [](const std::string& state, std::size_t iterations) {
    Document document = two_balls(0.3);
    RecordOptions record;
    record.state = state;
    record.resume = true;
    const TimeOptions time{.end = 0.4, .integrator = Integrator::midpoint, .tolerance = 1e-3};
    evolve_in_time(document, approaching(), time, unsmoothed(), {iterations, {}, record});
    return write_mesh(document).bytes;
  };
  const test::TemporaryFolder folder;
  const std::string state = folder / "state";
  for (const std::size_t limit : {1, 3, 5}) bytes(state, limit);
  CHECK(bytes(state, 1000) == bytes(folder / "other", 1000));
}

TEST_CASE("meaningless options are refused") {
  Mesh mesh = test::icosphere(1);
  const auto refuse = [&](const TimeOptions& time) {
    CHECK_THROWS_AS(evolve_in_time(mesh, growing(1), time), UsageError);
  };
  refuse({.end = 0});
  refuse({.end = INFINITY});
  refuse({.span = -1});
  refuse({.max_move = 0});
  refuse({.integrator = Integrator::euler, .tolerance = 1});
}

TEST_CASE("an open mesh has no volume to keep") {
  Mesh mesh = test::icosphere(1);
  mesh.faces.pop_back();
  CHECK_THROWS_AS(evolve_in_time(mesh, growing(0.1), {.keep_volume = true}, unsmoothed()),
                  InputError);
}

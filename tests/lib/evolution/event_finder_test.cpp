#include "evolution/event_finder.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "evolution/loop/event_row.h"
#include "helpers/revolution_flow.h"
#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"
#include "transformesh/boolean.h"
#include "transformesh/evolve_in_time.h"
#include "transformesh/flow.h"
#include "transformesh/measure.h"
#include "transformesh/shapes.h"
#include "transformesh/velocity.h"

using namespace transformesh;

namespace {

constexpr double tolerance = 1e-3;

/// Evolves in time and returns the events. `keeps_cavities` is the opposite of `outermost`. Ends
/// if a genus above 0 becomes 0.
std::vector<Event> events_of(Mesh& mesh, const VectorField& velocity, double end,
                             bool keeps_cavities = false, double edge = 0,
                             const TimeOptions& steps = {.event_tolerance = tolerance}) {
  EvolveOptions options;
  options.iteration.remesh = RemeshOptions();
  options.iteration.remesh.smoothing = Smoothing::none;
  options.iteration.outermost = !keeps_cavities;
  options.iteration.reference_edge = edge;
  options.finds_events = true;
  if (connected_components(mesh).genus() > 0) options.until.genus = 0;
  TimeOptions time = steps;
  time.end = end;
  return evolve_in_time(mesh, {velocity}, time, options).evolution.events;
}

/// Events of mean-curvature flow, in which loops of up to `pinch` are cut.
std::vector<Event> curvature_events(Mesh& mesh, double end, double pinch) {
  EvolveOptions options;
  options.iteration.remesh = RemeshOptions();
  options.iteration.remesh.smoothing = Smoothing::none;
  options.iteration.remesh.curved = true;
  options.iteration.remesh.pinch = pinch;
  options.finds_events = true;
  TimeOptions time;
  time.end = end;
  return evolve_in_time(mesh, make_flow("mean-curvature").motion, time, options).evolution.events;
}

std::string kinds(const std::vector<Event>& events) {
  std::string text;
  for (const Event& event : events) text += (text.empty() ? "" : ", ") + name_of(event.kind);
  return text;
}

/// Checks that mean-curvature flow makes one event at the origin, near the time. Returns the
/// result. A neck whose radius is 1.4 edges lasts as long as the square of an edge: r(t)^2 = r(0)^2
/// - 2 t. Fewer than about ten edges around a neck do not resolve its flow.
Mesh check_neck(ShapeOptions shape, double time, const char* kind) {
  shape.faces = 4000;
  Mesh mesh = make_shape(shape);
  const auto events = curvature_events(mesh, 1.3 * time, 0.2);
  REQUIRE(kinds(events) == kind);
  const double edge = edge_lengths(mesh).mean;
  MESSAGE(std::string(kind), " at ", events.front().time, ", expected at ", time);
  CHECK(std::abs(events.front().time - time) < edge * edge);
  CHECK(events.front().place.norm() < edge);
  return mesh;
}

/// Marks all vertices from `first` on.
void mask_from(Mesh& mesh, std::size_t first) {
  Column& mask = mesh.vertex_columns.get("mask", Scalar::float64, mesh.positions.size());
  for (std::size_t v = first; v < mesh.positions.size(); ++v) mask.values[v] = 1;
}

double mask_of(const Mesh& mesh, std::size_t v) {
  return mesh.vertex_columns.find("mask")->values[v];
}

/// Moves vertices by a function of their number and position.
VectorField moving(const std::function<Vec3(const Mesh& mesh, std::size_t vertex)>& velocity) {
  return [velocity](const Mesh& mesh, const Moment&, const Progress&) {
    std::vector<Vec3> velocities;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) velocities.push_back(velocity(mesh, v));
    return velocities;
  };
}

std::set<long> labels_of(const Mesh& mesh) {
  const Column* column = mesh.face_columns.find(component_label);
  REQUIRE(column != nullptr);
  std::set<long> labels;
  for (const double value : column->values) labels.insert(static_cast<long>(value));
  return labels;
}

}  // namespace

TEST_CASE("two balls that approach merge once, where and when they touch") {
  Mesh mesh = test::joined(test::scaled(test::icosphere(3), 0.9),
                           test::moved(test::icosphere(3), Vec3(2.2, 0, 0)));
  mask_from(mesh, mesh.positions.size() / 2);
  const double edge = edge_lengths(mesh).mean;
  const auto events = events_of(
      mesh, moving([](const Mesh& now, std::size_t v) { return Vec3(-mask_of(now, v), 0, 0); }),
      0.5);
  REQUIRE(kinds(events) == "merge");
  const Event& event = events.front();
  CHECK(std::abs(event.time - 0.3) < 2 * tolerance);
  CHECK((event.place - Vec3(0.9, 0, 0)).norm() < edge);
  CHECK(event.size < edge);
  REQUIRE(event.before.size() == 2);
  CHECK(event.before[0].label == 2);
  CHECK(event.before[1].label == 1);
  CHECK(event.after.front().label == 2);
  CHECK(event.after.front().volume ==
        doctest::Approx(event.before[0].volume + event.before[1].volume).epsilon(1e-3));
  CHECK(labels_of(mesh) == std::set<long>{2});
}

TEST_CASE("a dumbbell whose neck is pinched splits once, at the neck") {
  Mesh mesh = test::icosphere(4);
  for (Vec3& p : mesh.positions) {
    // The second half is larger.
    const double factor = (p.x() < 0 ? 1 : 1.1) * (0.25 + 0.75 * std::min(1.0, 4 * p.x() * p.x()));
    p = Vec3(3 * p.x(), factor * p.y(), factor * p.z());
  }
  const double edge = edge_lengths(mesh).mean;
  const auto events = events_of(
      mesh,
      [](const Mesh& now, const Moment&, const Progress& progress) {
        std::vector<Vec3> velocities = normal_velocities(now, -1);
        for (std::size_t v = 0; v < velocities.size(); ++v) {
          const double x = now.positions[v].x();
          velocities[v] *= std::max(0.0, 1 - x * x / 0.16);
        }
        progress("velocity");
        return velocities;
      },
      0.4);
  REQUIRE(kinds(events) == "split");
  const Event& event = events.front();
  CHECK(event.time == doctest::Approx(0.25).epsilon(0.1));
  CHECK(event.place.norm() < edge);
  CHECK(event.size < 0.2);
  REQUIRE(event.after.size() == 2);
  CHECK(event.before.front().label == 1);
  CHECK(event.after[0].label == 1);
  CHECK(event.after[1].label == 2);
  CHECK(event.after[0].volume > event.after[1].volume);
  CHECK(labels_of(mesh) == std::set<long>{1, 2});
}

TEST_CASE("by curvature a dumbbell pinches when the one-dimensional solver says, once") {
  ShapeOptions shape;
  shape.kind = "dumbbell";
  shape.neck = 0.15;
  Mesh mesh = check_neck(shape, test::pinch_time(test::dumbbell_profile(0.15, 401)), "split");
  CHECK(labels_of(mesh) == std::set<long>{1, 2});
}

TEST_CASE("by curvature the hole of a thick torus closes when the one-dimensional solver says") {
  ShapeOptions shape;
  shape.kind = "torus";
  shape.radius = 1;
  shape.tube = 0.75;
  check_neck(shape, test::pinch_time(test::torus_profile(1, 0.75, 400)), "handle closed");
}

TEST_CASE("a handle that opens and closes within a step is no event, and new faces get labels") {
  Mesh ball = test::icosphere(2);
  Mesh torus = test::torus(1, 0.3, 20, 10);
  EventFinder finder;
  IterationOptions options;
  finder.start(ball);
  torus.face_columns.get(component_label, Scalar::int32, torus.faces.size())
      .values.assign(torus.faces.size(), 1);
  finder.watch(options);
  finder.begin_step(ball);
  options.on_cleaned(ball, torus);
  CHECK(finder.has_found());
  Mesh pinched = ball;
  // A face of a cap, which has no label.
  pinched.face_columns.columns.front().values[5] = 0;
  options.on_cleaned(torus, pinched);
  CHECK(!finder.has_found());
  CHECK(labels_of(pinched) == std::set<long>{1});
  options.on_cleaned(pinched, torus);
  finder.end_step(torus, 1, 0.5);
  EvolveResult result;
  finder.report(result);
  CHECK(kinds(result.events) == "handle opened");
}

TEST_CASE("the hole of a torus closes once, in its middle") {
  Mesh mesh = test::torus(1, 0.6, 80, 48);
  const double edge = edge_lengths(mesh).mean;
  const auto events = events_of(
      mesh,
      [](const Mesh& now, const Moment&, const Progress&) { return normal_velocities(now, 1); },
      0.5);
  REQUIRE(kinds(events) == "handle closed");
  CHECK(std::abs(events.front().time - 0.4) < 0.02);
  CHECK(events.front().place.norm() < edge);
  CHECK(events.front().before.front().label == 1);
  CHECK(events.front().after.front().label == 1);
}

TEST_CASE("a small sphere that shrinks vanishes once, at its center") {
  Mesh mesh = test::icosphere(3);
  const std::size_t first = mesh.positions.size();
  mesh = test::joined(mesh, test::moved(test::scaled(test::icosphere(2), 0.3), Vec3(3, 0, 0)));
  mask_from(mesh, first);
  const auto events = events_of(
      mesh,
      [](const Mesh& now, const Moment&, const Progress&) {
        std::vector<Vec3> velocities = normal_velocities(now, -1);
        for (std::size_t v = 0; v < velocities.size(); ++v) velocities[v] *= mask_of(now, v);
        return velocities;
      },
      0.5);
  REQUIRE(kinds(events) == "component vanished");
  const Event& event = events.front();
  CHECK(event.time > 0.15);
  CHECK(event.time < 0.32);
  CHECK((event.place - Vec3(3, 0, 0)).norm() < 0.05);
  CHECK(event.before.front().label == 2);
  CHECK(event.after.empty());
  CHECK(labels_of(mesh) == std::set<long>{1});
}

TEST_CASE("a dent opens the cavity of a shell once") {
  const Mesh inner = test::reversed(test::scaled(test::icosphere(3), 0.6));
  Mesh mesh = test::joined(inner, test::icosphere(4));
  mask_from(mesh, inner.positions.size());
  const double edge = edge_lengths(mesh).mean;
  const auto events = events_of(mesh, moving([](const Mesh& now, std::size_t v) {
                                  const Vec3& p = now.positions[v];
                                  const double across = p.y() * p.y() + p.z() * p.z();
                                  const double speed =
                                      p.x() > 0 ? std::max(0.0, 1 - across / 0.16) : 0;
                                  return Vec3(-speed * mask_of(now, v), 0, 0);
                                }),
                                0.5, true);
  REQUIRE(kinds(events) == "cavity opened");
  const Event& event = events.front();
  CHECK(std::abs(event.time - 0.4) < 0.01);
  CHECK((event.place - Vec3(0.6, 0, 0)).norm() < 2 * edge);
  CHECK(event.before[0].label == 2);
  CHECK(event.before[1].label == 1);
  CHECK(event.before[1].volume < 0);
  CHECK(labels_of(mesh) == std::set<long>{2});
}

namespace {

/// A box from z = -1 to z = 0 with a pit in its upper side.
Mesh tray() {
  const Mesh solid = test::cuboid({-1, -1, -1}, {1, 1, 0});
  const Mesh pit = test::cuboid({-0.5, -0.5, -0.5}, {0.5, 0.5, 1});
  return boolean(BooleanOperation::subtract, {{&solid}, {&pit}}).mesh;
}

/// Two trays with pits that face each other over a gap of 0.2. The upper one is marked.
Mesh two_trays() {
  Mesh mesh = tray();
  const std::size_t first = mesh.positions.size();
  Mesh upper = mesh;
  for (Vec3& p : upper.positions) p = Vec3(p.x(), -p.y(), 0.2 - p.z());
  mesh = test::joined(mesh, upper);
  mask_from(mesh, first);
  return mesh;
}

std::vector<Event> close_trays(bool keeps_cavities, double& volume) {
  Mesh mesh = two_trays();
  const auto events = events_of(
      mesh, moving([](const Mesh& now, std::size_t v) { return Vec3(0, 0, -mask_of(now, v)); }),
      0.25, keeps_cavities, 0.3, {.span = 0.15, .event_tolerance = 0});
  volume = transformesh::volume(mesh);
  return events;
}

}  // namespace

TEST_CASE("two trays that meet close a cavity once, which is kept or filled") {
  double kept = 0, filled = 0;
  for (const bool keeps_cavities : {true, false}) {
    const auto events = close_trays(keeps_cavities, keeps_cavities ? kept : filled);
    REQUIRE(kinds(events) == "merge, cavity closed");
    CHECK(events.front().time == 0.25);
    const Event& event = events.back();
    CHECK(std::abs(event.place.z()) < 0.1);
    REQUIRE(event.after.size() == 2);
    CHECK(event.after[1].label == 3);
    CHECK(event.after[1].volume == doctest::Approx(-1).epsilon(0.05));
  }
  CHECK(filled - kept == doctest::Approx(1).epsilon(0.05));
}

namespace {

/// Balls in a row with gaps of 0.2 and 0.3; the mask is the number of the ball.
Mesh three_balls() {
  const Mesh ball = test::icosphere(2);
  Mesh mesh = test::joined(ball, test::moved(ball, {2.2, 0, 0}));
  mesh = test::joined(mesh, test::moved(ball, {4.5, 0, 0}));
  mask_from(mesh, ball.positions.size());
  Column& mask = *mesh.vertex_columns.find("mask");
  for (std::size_t v = 2 * ball.positions.size(); v < mask.values.size(); ++v) mask.values[v] = 2;
  return mesh;
}

}  // namespace

TEST_CASE(
    "events of a run that continues, and their labels, are those of one that is not stopped") {
  const auto rows_of = [](const test::TemporaryFolder& folder, std::vector<std::size_t> limits) {
    for (const std::size_t limit : limits) {
      Document document;
      document.mesh = three_balls();
      EvolveOptions options;
      options.iteration.remesh = RemeshOptions();
      options.iteration.remesh.smoothing = Smoothing::none;
      LoopOptions loop;
      loop.iterations = limit;
      loop.record.state = folder / "state";
      loop.record.resume = true;
      loop.record.events = folder / "events.csv";
      const auto left = moving(
          [](const Mesh& now, std::size_t v) { return Vec3(-std::round(mask_of(now, v)), 0, 0); });
      evolve_in_time(document, {left}, {.end = 0.5}, options, loop);
    }
    return test::content_of(folder / "events.csv");
  };
  const test::TemporaryFolder whole, parts;
  const std::string rows = rows_of(whole, {1000});
  CHECK(std::ranges::count(rows, '\n') == 3);
  CHECK(rows_of(parts, {1, 4, 9, 14, 1000}) == rows);
}

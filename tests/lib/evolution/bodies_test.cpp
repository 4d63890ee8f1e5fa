#include "evolution/bodies.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "evolution/recorded_loops.h"
#include "helpers/shapes.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/flow.h"
#include "transformesh/intersect.h"
#include "transformesh/measure.h"

using namespace transformesh;

namespace {

/// Returns a document in which the meshes are bodies 0, 1 and so on.
Document document_of(const std::vector<Mesh>& meshes) {
  Document document;
  std::vector<double> numbers;
  for (const Mesh& mesh : meshes) {
    document.mesh = test::joined(document.mesh, mesh);
    const double next = numbers.empty() ? 0 : numbers.back() + 1;
    numbers.resize(document.mesh.faces.size(), next);
  }
  document.mesh.face_columns.get("body", Scalar::uint8, numbers.size()).values = numbers;
  return document;
}

Mesh ball(double radius, const Vec3& center) {
  return test::moved(test::scaled(test::icosphere(3), radius), center);
}

/// Moves each vertex away from the center of its body at the speed of its body.
Motion growing(const std::vector<Vec3>& centers, const std::vector<double>& speeds) {
  return {[=](const Mesh& mesh, const Moment&, const Progress&) {
    std::vector<Vec3> velocities(mesh.positions.size(), Vec3::Zero());
    const std::vector<double>& numbers = mesh.face_columns.find("body")->values;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const auto body = static_cast<std::size_t>(numbers[f]);
      for (const Index v : mesh.faces[f])
        velocities[v] = speeds[body] * (mesh.positions[v] - centers[body]).normalized();
    }
    return velocities;
  }};
}

EvolveOptions unsmoothed() {
  EvolveOptions options;
  options.iteration.remesh = RemeshOptions();
  options.iteration.remesh.smoothing = Smoothing::none;
  return options;
}

double volume_of(const Document& document, double number) {
  for (const Body& body : split_bodies(document, "body"))
    if (body.number == number) return volume(body.document.mesh);
  return 0;
}

}  // namespace

TEST_CASE("bodies are split and joined with their columns") {
  Document document = document_of({ball(1, {0, 0, 0}), ball(1, {3, 0, 0})});
  const std::size_t faces = document.mesh.faces.size();
  const std::vector<Body> bodies = split_bodies(document, "body");
  REQUIRE(bodies.size() == 2);
  CHECK(bodies[1].number == 1);
  CHECK(bounding_box(bodies[1].document.mesh).center().x() == doctest::Approx(3));
  for (std::size_t v = 0; v < bodies[1].vertices.size(); ++v)
    CHECK(bodies[1].document.mesh.positions[v] == document.mesh.positions[bodies[1].vertices[v]]);
  join_bodies(bodies, "body", document);
  CHECK(document.mesh.faces.size() == faces);
  CHECK(volume_of(document, 1) == doctest::Approx(volume_of(document, 0)));
  CHECK_THROWS_AS(split_bodies(document, "label"), InputError);
}

TEST_CASE("two balls that grow press against each other and never meet") {
  const std::vector<Vec3> centers{{-1.2, 0, 0}, {1.2, 0, 0}};
  Document document = document_of({ball(1, centers[0]), ball(1, centers[1])});
  const TimeOptions time{.end = 0.5, .bodies = "body", .gap = 0.02};
  const TimeResult result = evolve_in_time(document, growing(centers, {1, 1}), time, unsmoothed());
  CHECK(result.evolution.last.topology == Topology{2, 0});
  CHECK(result.held_back > 0);
  CHECK(find_intersections(document.mesh).empty());
  // Each ball of radius 1.5 lacks the cap of height 0.3 beyond the plane x = 0. The balls move one
  // after the other, so the first ball may hold the second one back. Hence the sum of both volumes
  // is compared.
  const double whole = 4 * std::numbers::pi / 3 * std::pow(1.5, 3);
  const double cap = std::numbers::pi * 0.3 * 0.3 / 3 * (3 * 1.5 - 0.3);
  const double both = volume_of(document, 0) + volume_of(document, 1);
  CHECK(both == doctest::Approx(2 * (whole - cap)).epsilon(0.03));
}

TEST_CASE("an inner shell that grows faster stops at the outer one") {
  const std::vector<Vec3> centers{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  Document document =
      document_of({ball(1, centers[0]), ball(0.7, centers[0]), ball(0.4, centers[0])});
  const TimeOptions time{.end = 0.5, .bodies = "body", .gap = 0.02};
  evolve_in_time(document, growing(centers, {0.1, 1, 1}), time, unsmoothed());
  CHECK(connected_components(document.mesh).components.size() == 3);
  CHECK(find_intersections(document.mesh).empty());
  const double outer = volume_of(document, 0), middle = volume_of(document, 1);
  const double inner = volume_of(document, 2);
  CHECK(outer == doctest::Approx(4 * std::numbers::pi / 3 * std::pow(1.05, 3)).epsilon(0.02));
  CHECK(middle < outer);
  CHECK(inner < middle);
  // The factors allow for the gaps between the balls, and for the volume that balls of 1,280 flat
  // faces lack.
  CHECK(middle > 0.85 * outer);
}

TEST_CASE("a body that vanishes is an event, and the other bodies go on") {
  const std::vector<Vec3> centers{{0, 0, 0}, {3, 0, 0}};
  Document document = document_of({ball(0.3, centers[0]), ball(1, centers[1])});
  EvolveOptions options = unsmoothed();
  options.finds_events = true;
  const TimeOptions time{.end = 0.5, .bodies = "body", .gap = 0.02};
  const TimeResult result = evolve_in_time(document, growing(centers, {-1, 0.2}), time, options);
  CHECK(result.evolution.is_done);
  CHECK(result.evolution.last.topology == Topology{1, 0});
  REQUIRE(result.evolution.events.size() == 1);
  const Event& event = result.evolution.events[0];
  CHECK(event.kind == EventKind::component_vanished);
  CHECK(event.place.norm() < 0.05);
  CHECK(event.time == doctest::Approx(0.3).epsilon(0.15));
  const std::vector<Body> bodies = split_bodies(document, "body");
  REQUIRE(bodies.size() == 1);
  CHECK(bodies[0].number == 1);
  CHECK(volume(document.mesh) ==
        doctest::Approx(4 * std::numbers::pi / 3 * std::pow(1.1, 3)).epsilon(0.02));
}

TEST_CASE("parts of a body that merge are an event of that body") {
  Document document =
      document_of({test::joined(ball(1, {0, 0, 0}), ball(1, {2.2, 0, 0})), ball(0.5, {0, 3, 0})});
  EvolveOptions options = unsmoothed();
  options.finds_events = true;
  const TimeOptions time{.end = 0.2, .bodies = "body", .gap = 0.02};
  const TimeResult result = evolve_in_time(document, make_flow("normal").motion, time, options);
  REQUIRE(result.evolution.events.size() == 1);
  const Event& event = result.evolution.events[0];
  CHECK(event.kind == EventKind::merge);
  CHECK(event.time == doctest::Approx(0.1).epsilon(0.1));
  CHECK(connected_components(document.mesh).components.size() == 2);
}

TEST_CASE("a cavity that holds another body is not filled") {
  Mesh cavity = ball(0.6, {0, 0, 0});
  for (Face& face : cavity.faces) std::swap(face[0], face[1]);
  const Mesh shell = test::joined(ball(1, {0, 0, 0}), cavity);
  Document document = document_of({shell, ball(0.3, {0, 0, 0})});
  const TimeOptions time{.end = 0.1, .bodies = "body", .gap = 0.02};
  evolve_in_time(document, make_flow("translation").motion, time, unsmoothed());
  CHECK(volume_of(document, 0) == doctest::Approx(volume(shell)).epsilon(0.01));
}

TEST_CASE("volume that bodies lose by remeshing is reported") {
  Document document = document_of({test::cuboid(Vec3::Zero(), {2, 1, 0.3})});
  const TimeOptions time{.end = 1, .bodies = "body", .gap = 0.02};
  const TimeResult result =
      evolve_in_time(document, make_flow("translation").motion, time, unsmoothed());
  CHECK(result.volume_drift < -0.01);
  CHECK(volume(document.mesh) - result.volume_drift == doctest::Approx(0.6));
}

TEST_CASE("bodies that intersect at the beginning are refused with their number") {
  const std::vector<Vec3> centers{{-0.5, 0, 0}, {0.5, 0, 0}};
  Document document = document_of({ball(1, centers[0]), ball(1, centers[1])});
  const TimeOptions time{.end = 0.5, .bodies = "body", .gap = 0.02};
  try {
    evolve_in_time(document, growing(centers, {1, 1}), time, unsmoothed());
    FAIL("not refused");
  } catch (const InputError& error) {
    CHECK(std::string(error.what()).find("body 0: ") != std::string::npos);
  }
}

TEST_CASE("a body that is inside out is refused with its number") {
  Document document = document_of({ball(1, {0, 0, 0}), ball(1, {3, 0, 0})});
  for (std::size_t f = document.mesh.faces.size() / 2; f < document.mesh.faces.size(); ++f)
    std::swap(document.mesh.faces[f][0], document.mesh.faces[f][1]);
  const TimeOptions time{.end = 0.5, .bodies = "body", .gap = 0.02};
  CHECK_THROWS_WITH_AS(evolve_in_time(document, make_flow("normal").motion, time, unsmoothed()),
                       doctest::Contains("body 1: "), GoalError);
}

TEST_CASE("bodies without a gap, or with volumes to keep, are refused") {
  Document document = document_of({ball(1, {0, 0, 0})});
  const Motion rest = growing({{0, 0, 0}}, {0});
  CHECK_THROWS_AS(evolve_in_time(document, rest, {.bodies = "body"}), UsageError);
  CHECK_THROWS_AS(evolve_in_time(document, rest, {.keep_volume = true, .bodies = "body", .gap = 1}),
                  UsageError);
}

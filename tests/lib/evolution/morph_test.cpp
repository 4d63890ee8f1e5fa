#include "transformesh/morph.h"

#include <doctest/doctest.h>

#include "evolution/agreement.h"
#include "evolution/loop/record.h"
#include "evolution/morph_remedy.h"
#include "evolution/recorded_loops.h"
#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"
#include "io/length_basis.h"
#include "step/target_file.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;
using test::TemporaryFolder;

namespace {

Document ball(double radius) {
  Document document;
  document.mesh = test::scaled(test::icosphere(3), radius);
  return document;
}

MorphResult morphed(Document& document, const Target& target, const MorphOptions& options = {},
                    std::size_t iterations = 300) {
  Record none;
  return morph(document, target, options, {.iterations = iterations}, none);
}

}  // namespace

TEST_CASE("a ball around a torus becomes the torus") {
  Document document = ball(1.6);
  const Target target = make_target(test::torus(1, 0.4, 60, 30));
  const MorphResult result = morphed(document, target);
  CHECK(result.stop == MorphStop::converged);
  CHECK(result.topology == Topology{1, 1});
  CHECK(result.expected == Topology{1, 1});
  CHECK(result.fault.empty());
  CHECK(*result.to_target < edge_lengths(document.mesh).maximum / 2);
  CHECK(result.distances.displaced.moved == 0);
}

TEST_CASE("a mesh that already agrees with the target needs two iterations") {
  Document document = ball(1);
  const MorphResult result = morphed(document, make_target(test::icosphere(4)));
  CHECK(result.stop == MorphStop::converged);
  CHECK(result.iterations == 2);
}

TEST_CASE("vertices without faces do not keep a morph from converging") {
  Document document = ball(1);
  document.mesh.positions.emplace_back(9, 9, 9);
  CHECK(morphed(document, make_target(test::icosphere(4))).stop == MorphStop::converged);
}

TEST_CASE("a morph that misses a part of the target does not converge, and names the place") {
  const Mesh ball_there = test::moved(test::icosphere(3), Vec3(10, 0, 0));
  const Mesh target = test::joined(test::icosphere(3), ball_there);
  Document document = ball(1.1);
  const MorphResult result = morphed(document, make_target(target));
  CHECK(result.stop == MorphStop::stalled);
  CHECK(result.iterations < 60);
  CHECK(result.expected == Topology{2, 0});
  CHECK(result.fault.find("components 1 and genus 0, but those of the target are 2 and 0") == 0);
  CHECK(result.fault.find("at (11, ") != std::string::npos);
}

TEST_CASE(
    "the limit of iterations leaves a run that continues to the same bytes, from any of them") {
  const Target target = make_target(test::torus(1, 0.4, 40, 20));
  Document whole = ball(1.6);
  MorphOptions options;
  options.scales = 2;
  const MorphResult result = morphed(whole, target, options);
  CHECK(result.stop == MorphStop::converged);

  const TemporaryFolder folder;
  RecordOptions kept;
  kept.state = folder / "state";
  kept.resume = true;
  options.iteration.reference_edge = measured_reference_edge(ball(1.6).mesh);
  Document document = ball(1.6);
  for (std::size_t limit = 3;; limit += 9) {
    Record record(kept);
    const MorphResult part = morph(document, target, options, {.iterations = limit}, record);
    if (part.stop != MorphStop::iteration_limit) break;
    REQUIRE(limit < 200);
  }
  CHECK(write_mesh(document).bytes == write_mesh(whole).bytes);
  CHECK(folder.is_empty());
}

TEST_CASE("a target without faces has no topology to be reached") {
  Mesh points;
  points.positions = test::icosphere(4).positions;
  CHECK_FALSE(goal_of(make_target(points)).topology);
  CHECK(goal_of(make_target(test::torus(1, 0.4, 40, 20))).topology == Topology{1, 1});
  // An open mesh does not have one either.
  Mesh open = test::icosphere(3);
  open.faces.pop_back();
  CHECK_FALSE(goal_of(make_target(open)).topology);
}

TEST_CASE("cavities of the target, and components in them, are no goal") {
  const Mesh hollow =
      test::joined(test::icosphere(4), test::reversed(test::scaled(test::icosphere(3), 0.6)));
  const Mesh floating = test::joined(hollow, test::scaled(test::icosphere(2), 0.2));
  for (const Mesh& mesh : {hollow, floating}) {
    const Target target = make_target(mesh);
    CHECK(goal_of(target).left_out == (mesh.faces.size() == hollow.faces.size() ? 1 : 2));
    CHECK(goal_of(target).of(target).mesh.faces.size() == test::icosphere(4).faces.size());
    Document document = ball(1.2);
    const MorphResult result = morphed(document, target);
    CHECK(result.stop == MorphStop::converged);
    CHECK(result.distances.from_target.maximum < 0.1);
    CHECK(*result.from_target < 0.1);
  }
  const Target solid = make_target(test::icosphere(3));
  CHECK(goal_of(solid).left_out == 0);
  CHECK_FALSE(goal_of(solid).without_those);
}

TEST_CASE("the cause of a fault is found by measuring the target") {
  const auto kind = [](const Mesh& target, double radius) {
    Document document = ball(radius);
    const MorphResult result = morphed(document, make_target(target), {}, 100);
    CHECK(result.stop != MorphStop::converged);
    return result.cause.kind;
  };
  const Mesh balls = test::joined(test::icosphere(3), test::moved(test::icosphere(3), {2.1, 0, 0}));
  CHECK(kind(test::moved(balls, {-1.05, 0, 0}), 2.2) == ErrorKind::uniform_edges_too_long);
  const Mesh far = test::joined(test::icosphere(3), test::moved(test::icosphere(3), {10, 0, 0}));
  CHECK(kind(far, 1.1) == ErrorKind::source_apart);
  // The gap of 0.1 between the balls is narrow, but no edge length lets a mesh cross it.
  CHECK(kind(balls, 1) == ErrorKind::source_apart);
  Mesh open = test::icosphere(3);
  open.faces.resize(open.faces.size() * 3 / 4);
  CHECK(kind(open, 1.1) == ErrorKind::target_not_solid);
}

TEST_CASE("the cause that a surface vanishes is found for edges of any length") {
  const Target wide = make_target(test::icosphere(3));
  for (const double edge : {1e-2, 1e-6, 1e-150, 1e-310})
    CHECK(cause_of_vanishing(wide, edge, true).kind == ErrorKind::source_apart);
  const Target plate = make_target(test::cuboid({-1, -1, -5e-7}, {1, 1, 5e-7}));
  CHECK(cause_of_vanishing(plate, 1e-6, true).kind == ErrorKind::uniform_edges_too_long);
}

TEST_CASE("a surface that vanishes on a thin plate says so; shorter edges there reach it") {
  const Target plate = make_target(test::cuboid({-1, -1, -0.02}, {1, 1, 0.02}));
  Document document = ball(1.5);
  try {
    morphed(document, plate);
    FAIL("the plate is thinner than edges");
  } catch (const GoalError& error) {
    const std::string message = error.what();
    CHECK(message.starts_with("iteration "));
    CHECK(message.find("shrinks to nothing: the target is 0.04") != std::string::npos);
    CHECK(error.kind() == ErrorKind::uniform_edges_too_long);
    CHECK(error.data().lengths.at(0) == doctest::Approx(0.04));
    CHECK(error.data().position.has_value());
  }
  MorphOptions options;
  options.step.gap_edges = 1.5;
  document = ball(1.5);
  CHECK(morphed(document, plate, options).stop == MorphStop::converged);
  CHECK(volume(document.mesh) == doctest::Approx(0.16).epsilon(0.02));
}

TEST_CASE("a ball around a cube becomes the cube, unless its edges are to stay cut off") {
  const Target target = make_target(test::moved(test::cube(), Vec3(-0.5, -0.5, -0.5)));
  Document document = ball(1);
  const MorphResult result = morphed(document, target);
  CHECK(result.stop == MorphStop::converged);
  CHECK(result.aligned > 50);
  CHECK(*result.to_target < 1e-9);
  CHECK(*result.from_target < 1e-9);
  CHECK(volume(document.mesh) == doctest::Approx(1).epsilon(1e-9));

  Document cut_off = ball(1);
  MorphOptions options;
  options.features = Features::off;
  const MorphResult without = morphed(cut_off, target, options);
  CHECK(without.aligned == 0);
  CHECK(without.iterations == result.iterations);
  CHECK(*without.from_target > 0.05);
}

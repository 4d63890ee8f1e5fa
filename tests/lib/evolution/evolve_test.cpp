#include "transformesh/evolve.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "evolution/loop/record.h"
#include "evolution/recorded_loops.h"
#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"
#include "io/document/round_as_written.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"
#include "transformesh/mesh_io.h"
#include "transformesh/velocity.h"

using namespace transformesh;
using test::TemporaryFolder;

namespace {

Step growing(double speed) {
  return step_along(
      [speed](const Mesh& mesh, const Progress&) { return normal_velocities(mesh, speed); });
}

EvolveOptions unsmoothed() {
  EvolveOptions options;
  options.iteration.remesh = RemeshOptions();
  return options;
}

Document two_balls(double apart) {
  Document document;
  document.mesh =
      test::joined(test::icosphere(3), test::moved(test::icosphere(3), Vec3(2 + apart, 0, 0)));
  return document;
}

}  // namespace

TEST_CASE("a ball that grows by its normals has the volume of the larger ball") {
  Mesh mesh = test::icosphere(4);
  const EvolveResult result = evolve(mesh, growing(0.01), unsmoothed(), {.iterations = 20});
  CHECK(result.iterations == 20);
  CHECK_FALSE(result.is_done);
  const double radius = 1.2;
  CHECK(volume(mesh) ==
        doctest::Approx(4 * std::numbers::pi / 3 * std::pow(radius, 3)).epsilon(0.01));
}

TEST_CASE("two growing balls merge, and shrinking splits them again") {
  Document document = two_balls(0.2);
  Record record;
  const EvolveResult merged =
      evolve(document, growing(0.02), unsmoothed(), {.iterations = 10}, record);
  CHECK(merged.last.topology == Topology{1, 0});
  const EvolveResult parted =
      evolve(document, growing(-0.02), unsmoothed(), {.iterations = 25}, record);
  CHECK(parted.last.topology == Topology{2, 0});
}

TEST_CASE("an evolution ends when its vertices have come to rest") {
  const auto to_unit_sphere = step_along([](const Mesh& mesh, const Progress&) {
    std::vector<Vec3> velocities;
    for (const Vec3& p : mesh.positions) velocities.emplace_back(p.normalized() - p);
    return velocities;
  });
  EvolveOptions options = unsmoothed();
  options.until = moved_less_than(1e-3);
  Mesh mesh = test::scaled(test::icosphere(3), 1.3);
  const EvolveResult result = evolve(mesh, to_unit_sphere, options);
  CHECK(result.is_done);
  CHECK(result.last.displaced.max_displacement < 1e-3);
  CHECK(result.iterations < 40);

  options.until = stalled();
  const EvolveResult at_rest = evolve(mesh, to_unit_sphere, options, {.iterations = 200});
  CHECK(at_rest.is_done);
}

TEST_CASE("a run that was ended continues to the same bytes, in double and in float") {
  for (const Scalar coordinate : {Scalar::float64, Scalar::float32}) {
    const TemporaryFolder folder;
    Document begun = two_balls(0.1);
    begun.style.coordinate = coordinate;
    begun.mesh.vertex_columns.get("heat", Scalar::float32, begun.mesh.positions.size()).values[7] =
        0.7F;
    round_as_written(begun);
    EvolveOptions options = unsmoothed();
    options.iteration.reference_edge = edge_lengths(begun.mesh).mean;

    Document whole = begun;
    Record none;
    evolve(whole, growing(0.02), options, {.iterations = 8}, none);

    RecordOptions kept;
    kept.state = folder / "state";
    Document parts = begun;
    Record first(kept);
    evolve(parts, growing(0.02), options, {.iterations = 5}, first);
    kept.resume = true;
    Record second(kept);
    Document continued;
    evolve(continued, growing(0.02), options, {.iterations = 8}, second);
    CHECK(write_mesh(continued).bytes == write_mesh(whole).bytes);
  }
}

TEST_CASE("a step that leaves nothing is named as the cause") {
  const Step turning = [](Mesh& mesh, const Progress&) {
    for (Vec3& position : mesh.positions) position = -position;
    return DisplaceResult{.moved = mesh.positions.size(), .mean_edge = 1};
  };
  Mesh mesh = test::icosphere(3);
  try {
    evolve(mesh, turning, unsmoothed());
    FAIL("the step turns the sphere inside out");
  } catch (const GoalError& error) {
    CHECK(std::string(error.what()).starts_with("iteration 1: no surface is left after this step"));
    CHECK(error.kind() == ErrorKind::surface_vanished);
  }
}

TEST_CASE("a failure names its iteration and leaves the mesh of the one before") {
  int calls = 0;
  const Step failing = [&](Mesh& mesh, const Progress& progress) {
    if (++calls == 3) throw GoalError(ErrorKind::one_sided, "no luck today", {.faces = {7}});
    return growing(0.01)(mesh, progress);
  };
  Mesh mesh = test::icosphere(3);
  try {
    evolve(mesh, failing, unsmoothed());
    FAIL("the step fails");
  } catch (const GoalError& error) {
    CHECK(std::string(error.what()) == "iteration 3: no luck today");
    CHECK(error.kind() == ErrorKind::one_sided);
    CHECK(error.data().faces == std::vector<std::size_t>{7});
  }
  Mesh two = test::icosphere(3);
  evolve(two, growing(0.01), unsmoothed(), {.iterations = 2});
  CHECK(mesh.positions == two.positions);
}

TEST_CASE("an evolution can be cancelled, and its mesh is that of an iteration") {
  int calls = 0;
  const Progress progress([&](std::string_view, double) { return ++calls < 40; });
  Mesh mesh = test::icosphere(3);
  CHECK_THROWS_AS(evolve(mesh, growing(0.01), unsmoothed(), {}, progress), CancelledError);
  CHECK_FALSE(mesh.faces.empty());
}

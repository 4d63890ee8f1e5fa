#include "transformesh/iteration.h"

#include <doctest/doctest.h>

#include <cmath>
#include <utility>

#include "evolution/loop/iteration_text.h"
#include "evolution/loop/stages.h"
#include "helpers/mesh_facts.h"
#include "helpers/shapes.h"
#include "io/document/round_as_written.h"
#include "support/parallel.h"
#include "transformesh/clean.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"
#include "transformesh/mesh_io.h"
#include "transformesh/shapes.h"
#include "transformesh/velocity.h"

using namespace transformesh;

namespace {

Document two_balls(double apart, Scalar coordinate) {
  Document document;
  document.mesh =
      test::joined(test::icosphere(3), test::moved(test::icosphere(3), Vec3(2 + apart, 0, 0)));
  document.style.coordinate = coordinate;
  round_as_written(document);
  return document;
}

Step growing(double speed) {
  return step_along(
      [speed](const Mesh& mesh, const Progress&) { return normal_velocities(mesh, speed); });
}

}  // namespace

TEST_CASE("an iteration is displace, clean and remesh, each read back as it would be written") {
  for (const Scalar coordinate : {Scalar::float32, Scalar::float64}) {
    Document together = two_balls(0.05, coordinate);
    Document apart = together;
    IterationOptions options = completed({}, together.mesh);
    CHECK(options.reference_edge == doctest::Approx(edge_lengths(together.mesh).mean));
    const IterationResult result = iterate(together, growing(0.05), options);

    const auto through_a_file = [&apart] {
      apart.style.format = Format::ply_little;
      apart = read_mesh(write_mesh(apart).bytes, "between").document;
    };
    const std::size_t vertices = apart.mesh.positions.size();
    displace(apart.mesh, normal_velocities(apart.mesh, 0.05), {});
    through_a_file();
    const CleanResult cleaned =
        clean(apart.mesh, {.outermost = true, .coordinate = coordinate}, Progress());
    apart.mesh = cleaned.mesh;
    through_a_file();
    RemeshOptions remeshing = smoothed_by(0.1);
    remeshing.min_edge = 0.7 * options.reference_edge;
    remeshing.max_edge = 1.5 * options.reference_edge;
    remeshing.coordinate = coordinate;
    remesh(apart.mesh, remeshing);
    through_a_file();

    CHECK(together.mesh.positions == apart.mesh.positions);
    CHECK(together.mesh.faces == apart.mesh.faces);
    CHECK(result.vertices == vertices);
    CHECK(result.pairs == cleaned.pairs);
    CHECK(result.pairs > 0);
    CHECK(result.faces == together.mesh.faces.size());
    CHECK(moved_share(result) == 1);
  }
}

TEST_CASE("an iteration pinches as remesh() does, and refuses lengths that are none") {
  ShapeOptions shape;
  shape.kind = "dumbbell";
  shape.neck = 0.1;
  shape.faces = 3000;
  Document document;
  document.mesh = make_shape(shape);
  IterationOptions options = completed({}, document.mesh);
  RemeshOptions alone = options.remesh;
  alone.min_edge = 0.7 * options.reference_edge;
  alone.max_edge = 1.5 * options.reference_edge;
  options.remesh.pinch = alone.pinch = 1;
  Mesh expected = document.mesh;
  CHECK(remesh(expected, alone).pinched > 0);
  const Step still = [](Mesh&, const Progress&) { return DisplaceResult(); };
  Document moved = document;
  CHECK(iterate(moved, still, options).topology.components == 2);
  CHECK(moved.mesh.positions == expected.positions);
  CHECK(moved.mesh.faces == expected.faces);
  for (const double length : {-1.0, std::nan(""), HUGE_VAL}) {
    options.remesh.pinch = length;
    CHECK_THROWS_AS(iterate(document, still, options), UsageError);
  }
}

TEST_CASE("on curves, threads that cleaning leaves are cut and removed") {
  // Two balls of edges of .15, joined by two square bars of circumference .04: genus 1.
  const auto bar = [](double y) { return test::cuboid({0.5, y, 0}, {2, y + 0.01, 0.01}); };
  Document joined = two_balls(0.5, Scalar::float64);
  joined.mesh = test::joined(joined.mesh, test::joined(bar(0.2), bar(-0.2)));
  const Step still = [](Mesh&, const Progress&) { return DisplaceResult(); };
  const double volume_of_balls = 2 * volume(test::icosphere(3));
  IterationOptions options;
  options.reference_edge = edge_lengths(test::icosphere(3)).mean;
  const auto iterated = [&](bool curved, bool cleans_before, int threads) {
    const ThreadLimit limit(threads);
    options.remesh = curved ? curved_remeshing() : RemeshOptions();
    Document document = joined;
    if (cleans_before) document.mesh = clean(document.mesh).mesh;
    const IterationResult result = iterate(document, still, options);
    CHECK(result.was_cleaned == !cleans_before);
    if (curved && !cleans_before)
      CHECK(volume(document.mesh) == doctest::Approx(volume_of_balls).epsilon(0.001));
    return result.topology;
  };
  for (const int threads : {1, 2}) {
    CHECK(iterated(true, false, threads) == Topology{2, 0});
    // Without a change by cleaning, or without curves, the bars stay.
    CHECK(iterated(true, true, threads) == Topology{1, 1});
    CHECK(iterated(false, false, threads) == Topology{1, 1});
  }
}

TEST_CASE("whether remeshing begins beside cleaning or after it, the result is the same") {
  for (const double apart : {0.05, 0.5}) {
    const Document before = two_balls(apart, Scalar::float64);
    IterationOptions options = completed({}, before.mesh);
    const auto iterated = [&](int threads, bool expects_changes) {
      const ThreadLimit limit(threads);
      options.expects_changes = expects_changes;
      Document document = before;
      const IterationResult result = iterate(document, growing(0.05), options);
      CHECK(result.was_cleaned == (apart < 0.1));
      CHECK(result.faces == document.mesh.faces.size());
      return document.mesh;
    };
    const Mesh expected = iterated(1, false);
    for (const auto& [threads, expects_changes] :
         {std::pair(1, true), std::pair(2, false), std::pair(2, true), std::pair(4, false)}) {
      const Mesh mesh = iterated(threads, expects_changes);
      CHECK(mesh.positions == expected.positions);
      CHECK(mesh.faces == expected.faces);
    }
  }
}

TEST_CASE("an iteration that leaves nothing, or is cancelled, says so beside cleaning as well") {
  for (const int threads : {1, 2}) {
    const ThreadLimit limit(threads);
    const auto stay = [](Mesh&, const Progress&) { return DisplaceResult(); };
    Document document = two_balls(1, Scalar::float64);
    IterationOptions options = completed({}, document.mesh);
    options.reference_edge *= 20;
    CHECK_THROWS_WITH_AS(iterate(document, stay, options),
                         doctest::Contains("nothing would be left"), GoalError);
    document = two_balls(1, Scalar::float64);
    options = completed({}, document.mesh);
    const Progress cancel([](std::string_view phase, double) { return phase != "stitch"; });
    CHECK_THROWS_AS(iterate(document, stay, options, cancel), CancelledError);
  }
}

TEST_CASE("the reported topology is that of the result, by Euler's number") {
  for (const double apart : {0.05, 0.5}) {
    Document document = two_balls(apart, Scalar::float64);
    const IterationResult result = iterate(document, growing(0.05), completed({}, document.mesh));
    const bool has_met = apart < 0.1;
    CHECK(result.topology.components == (has_met ? 1 : 2));
    CHECK((result.pairs > 0) == has_met);
    const Mesh& mesh = document.mesh;
    const long euler =
        static_cast<long>(mesh.positions.size()) - static_cast<long>(mesh.faces.size()) / 2;
    CHECK(euler == 2 * static_cast<long>(result.topology.components) - 2 * result.topology.genus);
  }
}

TEST_CASE("lengths are in units of the reference edge, and longer by the factor of a scale") {
  for (const double factor : {1.0, 2.0}) {
    Document document = two_balls(1, Scalar::float64);
    IterationOptions options = completed({}, document.mesh);
    options.edge_factor = factor;
    const auto stay = [](Mesh&, const Progress&) { return DisplaceResult(); };
    for (int i = 0; i < 4; ++i) iterate(document, stay, options);
    const EdgeLengths edges = edge_lengths(document.mesh);
    CHECK(edges.mean > 0.7 * factor * options.reference_edge);
    CHECK(edges.mean < 1.5 * factor * options.reference_edge);
  }
}

TEST_CASE("faces and topology in words and in short") {
  CHECK(in_words(812, {1, 0}) == "812 faces, 1 component, genus 0");
  CHECK(in_words(1, {2, 3}) == "1 face, 2 components, genus 3");
  CHECK(in_short(812, {2, 1}) == "812 faces, components 2, genus 1");
}
